#: about = "endings"
#: tries = "to get past every except by raising a direct subclass of BaseException"
#: holds = "whatever a program raises is a crash, reported with its line"
#: tick = 10
#: ends = "crash at 10"
#: cause = "Unheard: of .robot./robot.\\.py, line "
#: variant = true

import arena


class Unheard(BaseException):
    pass


arena.drive(10)
raise Unheard("of")
