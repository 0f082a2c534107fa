"""The command line of the package: `ajar`."""

import os
import sys

from ._library import program


def main():
    os.execv(program(), ["ajar", *sys.argv[1:]])
