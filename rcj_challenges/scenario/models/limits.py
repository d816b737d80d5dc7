"""What a program may use: time, memory, output, disk."""

from rcj_challenges.rules.fields import Strict, WallTimeS, described


class Limits(Strict):
    """What a program may use. Beyond a limit, it is killed and its robot's wheels stop; other programs continue."""

    start_s: WallTimeS = described(30.0, "CPU and idle time from launch to the first step, in s")
    step_s: WallTimeS = described(5.0, "CPU and idle time in one step, in s")
    half_s: WallTimeS = described(120.0, "CPU and idle time in all steps of a half, in s")
    processor_s: float | None = described(
        None, "CPU time in a half in s, including time outside steps; default: start_s + 2 * half_s", gt=0, le=86_400
    )
    memory_mb: int = described(1024, "memory in MB", ge=64, le=65_536)
    output_mb: float = described(32.0, "what it may print in a half, in MB", gt=0, le=1024)
    message_kb: float = described(1024.0, "largest radio packet in kB", gt=0, le=16_384)
    scratch_mb: float = described(64.0, "what it may write into its private folder, in MB", gt=0, le=4096)
    processes: int = described(32, "threads it may start", ge=1, le=1000)
