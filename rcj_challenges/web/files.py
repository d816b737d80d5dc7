"""Answers with the content of a file, read bit by bit whatever serves them."""

from __future__ import annotations

import asyncio
from collections.abc import AsyncIterator
from pathlib import Path
from typing import Any

from django.http import FileResponse, Http404

HTML = "text/html; charset=utf-8"


class FileAnswer(FileResponse):
    """A file, which is not held in memory: by itself Django reads it whole under ASGI, and warns of it."""

    async def __aiter__(self) -> AsyncIterator[bytes]:
        """Yield the content."""
        stream = self.file_to_stream
        while stream is not None and (part := await asyncio.to_thread(stream.read, self.block_size)):
            yield part


def file_answer(path: Path, **options: Any) -> FileAnswer:
    """Return the content of a file.

    Raises:
        Http404: there is none.
    """
    try:
        return FileAnswer(path.open("rb"), **options)
    except OSError as error:
        raise Http404 from error
