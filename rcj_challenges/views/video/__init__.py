"""Videos and pictures of recorded runs: ``rcj-challenge video`` and ``snapshot``.

MuJoCo draws the recorded world, Pillow writes over it, PyAV makes the MP4. Reading records belongs to `records`, the
list of events to the replay. Only `scene` and `renderer` import mujoco, inside `requirements.offscreen_opengl`.
"""
