#: about = "module"
#: tries = "to suppress the report of its error: every import fails, and audit hooks refuse everything"
#: holds = "the report falls back to parts that need no import"
#: tick = 10
#: ends = "crash at 10"
#: cause = "ValueError"

import sys

import arena


class Nothing:
    def find_spec(self, *_):
        raise KeyboardInterrupt


def refuse(event, *_):
    if armed:
        raise KeyboardInterrupt


armed = False
arena.drive(10)
sys.addaudithook(refuse)
for name in ("traceback", "linecache", "tokenize"):
    sys.modules.pop(name, None)
sys.meta_path.insert(0, Nothing())
armed = True
raise ValueError("untold")
