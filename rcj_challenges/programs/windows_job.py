"""Windows only: a job object holds a program and all that it starts, limits its memory and ends with this process."""

from __future__ import annotations

import sys

if sys.platform == "win32":
    import ctypes
    import msvcrt
    import os
    import subprocess
    from ctypes import wintypes

    # winnt.h
    _BASIC_ACCOUNTING = 1
    _ACCOUNTING_WORDS = 6  # of 8 bytes: user time, kernel time, and four that are not needed here
    _EXTENDED_LIMITS = 9
    _LIMIT_PROCESS_MEMORY = 0x100
    _LIMIT_DIE_ON_UNHANDLED_EXCEPTION = 0x400
    _LIMIT_KILL_ON_JOB_CLOSE = 0x2000

    class _BasicLimits(ctypes.Structure):
        _fields_ = (
            ("PerProcessUserTimeLimit", ctypes.c_int64),
            ("PerJobUserTimeLimit", ctypes.c_int64),
            ("LimitFlags", wintypes.DWORD),
            ("MinimumWorkingSetSize", ctypes.c_size_t),
            ("MaximumWorkingSetSize", ctypes.c_size_t),
            ("ActiveProcessLimit", wintypes.DWORD),
            ("Affinity", ctypes.c_size_t),
            ("PriorityClass", wintypes.DWORD),
            ("SchedulingClass", wintypes.DWORD),
        )

    class _ExtendedLimits(ctypes.Structure):
        _fields_ = (
            ("BasicLimitInformation", _BasicLimits),
            ("IoInfo", ctypes.c_uint64 * 6),
            ("ProcessMemoryLimit", ctypes.c_size_t),
            ("JobMemoryLimit", ctypes.c_size_t),
            ("PeakProcessMemoryUsed", ctypes.c_size_t),
            ("PeakJobMemoryUsed", ctypes.c_size_t),
        )

    _kernel = ctypes.WinDLL("kernel32", use_last_error=True)
    _kernel.CreateJobObjectW.restype = wintypes.HANDLE
    _kernel.CreateJobObjectW.argtypes = (ctypes.c_void_p, wintypes.LPCWSTR)
    _kernel.SetInformationJobObject.argtypes = (wintypes.HANDLE, ctypes.c_int, ctypes.c_void_p, wintypes.DWORD)
    _kernel.QueryInformationJobObject.argtypes = (
        wintypes.HANDLE,
        ctypes.c_int,
        ctypes.c_void_p,
        wintypes.DWORD,
        ctypes.c_void_p,
    )
    _kernel.AssignProcessToJobObject.argtypes = (wintypes.HANDLE, wintypes.HANDLE)
    _kernel.TerminateJobObject.argtypes = (wintypes.HANDLE, wintypes.UINT)
    _kernel.CloseHandle.argtypes = (wintypes.HANDLE,)

    def _checked(result: int) -> int:
        if not result:
            raise ctypes.WinError(ctypes.get_last_error())
        return result

    class Job:
        """A job object for one program."""

        def __init__(self, memory_bytes: int | None) -> None:
            self._handle = _checked(_kernel.CreateJobObjectW(None, None))
            limits = _ExtendedLimits()
            flags = _LIMIT_KILL_ON_JOB_CLOSE | _LIMIT_DIE_ON_UNHANDLED_EXCEPTION
            if memory_bytes is not None:
                flags |= _LIMIT_PROCESS_MEMORY
                limits.ProcessMemoryLimit = memory_bytes
            limits.BasicLimitInformation.LimitFlags = flags
            _checked(
                _kernel.SetInformationJobObject(
                    self._handle, _EXTENDED_LIMITS, ctypes.byref(limits), ctypes.sizeof(limits)
                )
            )

        def add(self, popen: subprocess.Popen[bytes]) -> None:
            """Put a process into the job; what it starts from now on is in it too."""
            _checked(_kernel.AssignProcessToJobObject(self._handle, int(popen._handle)))  # noqa: SLF001

        def computed_s(self) -> float:
            """Return the processor time of all that was ever in the job, in s."""
            times = (ctypes.c_int64 * _ACCOUNTING_WORDS)()
            size = ctypes.sizeof(times)
            _checked(
                _kernel.QueryInformationJobObject(self._handle, _BASIC_ACCOUNTING, ctypes.byref(times), size, None)
            )
            return float(times[0] + times[1]) / 1e7

        def terminate(self) -> None:
            """End all that is in the job. Can be called again."""
            if self._handle:
                _kernel.TerminateJobObject(self._handle, 1)
                _kernel.CloseHandle(self._handle)
                self._handle = 0

    def startup_info(inherited: list[int]) -> subprocess.STARTUPINFO:
        """Return settings that let a new process inherit only these file descriptors and its standard streams."""
        handles = [msvcrt.get_osfhandle(fd) for fd in inherited]
        for handle in handles:
            os.set_handle_inheritable(handle, True)
        return subprocess.STARTUPINFO(lpAttributeList={"handle_list": handles})
