#: about = "endings"
#: tries = "to break the report of its error: text, type, context and frames raise errors when they are read"
#: holds = "the report falls back to parts that cannot be broken"
#: tick = 10
#: ends = "crash at 10"

import arena


class Meta(type):
    @property
    def __name__(cls):
        raise KeyboardInterrupt


class Trap(Exception, metaclass=Meta):
    def __str__(self):
        raise SystemExit

    __repr__ = __str__

    @property
    def __notes__(self):
        raise SystemExit

    __cause__ = __context__ = __notes__


arena.drive(10)
raise Trap
