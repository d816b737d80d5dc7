import time
from datetime import date, datetime, timedelta, timezone

from controller import Robot

robot = Robot()
robot.step(32)
stamps = [time.time_ns(), time.time_ns()]
print(stamps[1] - stamps[0], time.strftime("%Y-%m-%d %H:%M:%S"), time.localtime().tm_year, time.gmtime(0).tm_year, time.ctime())
print(datetime.now(), datetime.utcnow().date(), date.today(), datetime.now(timezone.utc).isoformat())
then = datetime.now()
time.sleep(3)
passed = datetime.now() - then
print(round(passed.total_seconds(), 3), isinstance(then, datetime), type(then - timedelta(1)) is datetime, isinstance(then, date))
uptime = time.clock_gettime(time.CLOCK_MONOTONIC) if hasattr(time, "clock_gettime") else time.monotonic()  # Windows has none
print(f"{time.monotonic():.3f} {time.perf_counter():.3f} {time.process_time():.3f} {uptime:.3f}")
for wrong in (-1, "long"):
    try:
        time.sleep(wrong)
    except (ValueError, TypeError) as error:
        print(error)
robot.step(32)
