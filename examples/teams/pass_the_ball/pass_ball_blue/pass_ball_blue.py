"""Merry Go Round: the robots that solve "The ball passing machines". This is the program of B1 and B2.

The idea: the ball never stops. Each robot hits it while it rolls, like in table tennis: the face looks into the right
direction, and one blow at full speed sends the ball to the next robot. A round takes little more than four seconds.

All four robots run the same program. It lies in the folder `pass_library`, beside ours:

* `player.py` listens to the referee and decides what to do,
* `touch.py` knows how a rolling ball leaves a face that hits it,
* `ring.py` knows the quarters and the ring in which the ball goes round.

The folder `driving` drives, shoots a ball that lies still (the first one), and holds measures and geometry.
"""

import sys

sys.path.append("..")  # there lie pass_library and driving

from pass_library.player import Player

Player().run()
