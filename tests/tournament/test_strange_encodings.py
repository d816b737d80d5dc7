"""A file in an encoding that is none for text does not end the comparison of submissions."""

import pytest

from rcj_challenges.tournament.site.similarity import token_rows


@pytest.mark.parametrize("encoding", ["hex", "rot13", "zlib"])
def test_file_in_an_encoding_for_bytes_has_no_rows(encoding):
    assert token_rows(f"# coding: {encoding}\nx = 1\n".encode()) == frozenset()
