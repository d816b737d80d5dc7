"""Answers with the content of a file, read bit by bit whatever serves them."""

from __future__ import annotations

import asyncio
from collections.abc import AsyncIterator

from django.http import FileResponse


class FileAnswer(FileResponse):
    """A file, which is not held in memory: by itself Django reads it whole under ASGI, and warns of it."""

    async def __aiter__(self) -> AsyncIterator[bytes]:
        """Yield the content."""
        stream = self.file_to_stream
        while stream is not None and (part := await asyncio.to_thread(stream.read, self.block_size)):
            yield part
