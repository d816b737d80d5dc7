#: about = "processes and system"
#: tries = "to make an administrator's system calls, with harmless arguments: mount, chroot, namespaces, host name, modules, log"
#: holds = "they are refused, even if the match runs as root"
#: layers = ["system_calls"]
#: platforms = ["linux"]
#: tick = 10
#: ends = "plays on"
#: said = ["refused: mount", "refused: unshare", "refused: bpf", "refused: io_uring_setup", "refused: userfaultfd"]

import arena

arena.drive(10)
for name in (
    "mount umount2 chroot pivot_root unshare setns sethostname swapoff init_module kexec_load acct bpf "
    "perf_event_open userfaultfd keyctl add_key io_uring_setup open_by_handle_at"
).split():
    arena.syscall(name, arena.number_of(name), None, None, 0, 0, 0)
arena.play_on()
