"""Videos and pictures of recorded runs: ``rcj-challenge video`` and ``snapshot``.

Belongs here: which moments are shown, drawing them (from above by Pillow, in 3-D by MuJoCo), writing over them, and
the MP4. Does not belong here: reading records (records), telling what happened (replay's story), the replay page.
This is the one place of the views that may load mujoco: `solid` and `solid_model` do, and `gl_probe` does in a process
of its own. Pillow and PyAV are extras: check with `errors.need_extra` before importing anything else from here.
"""
