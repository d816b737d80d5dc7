#: about = "processes and system"
#: tries = "to open sockets: TCP, UDP, IPv6, raw, netlink, Unix, abstract Unix; and to resolve names"
#: holds = "sockets are refused"
#: layers = ["system_calls"]
#: platforms = ["linux"]
#: tick = 10
#: ends = "plays on"
#: succeeds_without = true
#: said = ["refused: tcp", "refused: udp", "refused: unix", "refused: abstract", "refused: netlink"]

import socket

import arena


def opened(family, kind, address=None):
    with socket.socket(family, kind) as made:
        if address is not None:
            made.bind(address)


arena.drive(10)
arena.refused("tcp", opened, socket.AF_INET, socket.SOCK_STREAM, ("127.0.0.1", 0))
arena.refused("tcp6", opened, socket.AF_INET6, socket.SOCK_STREAM)
arena.refused("udp", opened, socket.AF_INET, socket.SOCK_DGRAM)
arena.refused("unix", opened, socket.AF_UNIX, socket.SOCK_STREAM, "rcj-hostile-socket")
arena.refused("abstract", opened, socket.AF_UNIX, socket.SOCK_DGRAM, "\0rcj-hostile")
arena.refused("netlink", opened, socket.AF_NETLINK, socket.SOCK_RAW)
arena.refused(
    "connection",
    lambda: socket.create_connection(("127.0.0.1", 9), 1) if False else opened(socket.AF_INET, socket.SOCK_STREAM),
)
arena.play_on()
