"""Kinds of fields of nodes, as numbers."""

from __future__ import annotations

from ._unsupported import Unsupported


class Field(Unsupported):
    """Constants only; a program cannot get fields."""

    NO_FIELD, SF_BOOL, SF_INT32, SF_FLOAT, SF_VEC2F, SF_VEC3F, SF_ROTATION, SF_COLOR, SF_STRING, SF_NODE = range(10)
    MF, MF_BOOL, MF_INT32, MF_FLOAT, MF_VEC2F, MF_VEC3F, MF_ROTATION, MF_COLOR, MF_STRING, MF_NODE = range(16, 26)
