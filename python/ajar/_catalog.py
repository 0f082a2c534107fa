"""What there is to choose from."""

import functools

from ._library import call_for_json


@functools.lru_cache(maxsize=None)
def catalog(kind):
    """As `ajar list KIND --json` has it: not to be changed."""
    return call_for_json("ajar_catalog", kind.encode())


def _summaries(kind):
    return {entry["name"]: entry["summary"] for entry in catalog(kind)}


def list_integrators():
    """The methods by name, each with one line about it."""
    return _summaries("integrators")


def list_scenes():
    """The built-in scenes by name, as `ajar.load` takes them."""
    return _summaries("scenes")


def list_aovs():
    """The layers that `render` can be asked for."""
    return _summaries("aovs")
