"""What parameters of nodes take, for type checkers."""

from __future__ import annotations

import os
from collections.abc import Sequence
from typing import Union

import numpy
from numpy.typing import ArrayLike

from ._nodes import Node

File = Union[str, os.PathLike, numpy.ndarray]
Number = float
TexturedNumber = Union[float, Node, numpy.ndarray]
Color = Union[float, Sequence[float], numpy.ndarray]
TexturedColor = Union[Color, Node]
Vector = Union[Sequence[float], numpy.ndarray]
Transform = ArrayLike

__all__ = ["ArrayLike", "Color", "File", "Node", "Number", "TexturedColor", "TexturedNumber", "Transform", "Vector"]
