#: about = "memory and files"
#: tries = "to find the seed of the match, or other robots' names, in the objects of its own process"
#: holds = "a process gets only its own seed, a one-way hash derived from the seed of the match"
#: tick = 10
#: ends = "plays on"
#: said = ["looked at \\d+ dicts"]
#: variant = true

import gc

import arena

arena.drive(10)
looked = 0
for thing in gc.get_objects():
    if type(thing) is dict:
        looked += 1
        # Python itself may keep all texts of this program in a dictionary: there the name stands for itself.
        if thing.get("match_seed", "match_seed") != "match_seed" or (thing.get("name") in ("B1", "B2", "B3") and "devices" in thing):
            print("BROKEN: found", sorted(map(str, thing))[:10])
print("looked at", looked, "dicts")
arena.play_on()
