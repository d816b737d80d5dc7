"""What a field of a model names: `Ref` for what is on the field, `SectionRef` for an entry of a section.

A field says so in its annotation, ``entity: Annotated[Names, ENTITIES]``. The check of names, lint, the substitution of
``other`` and the made-up scenarios of the tests read it from there.
"""

from dataclasses import dataclass, replace
from functools import cache

from pydantic import BaseModel


@dataclass(frozen=True)
class Ref:
    """A reference to something on the field: entities, zones, gates, spots, or groups of them.

    Attributes:
        groups: whether a group's name may stand for its members.
        each: whether ``each`` may stand there, within a rule with ``for_each``, and ``other``, within one of touches.
        drawn: whether a draw's name may stand for what it decided.
        keys: True if the names are the keys of the mapping.
        instead: what to write in place of what is of these kinds, such as of an obstacle, where something that moves or
            tips is needed; empty: the usual.
        instead_of: those kinds.
    """

    noun: str
    kinds: frozenset[str]
    groups: bool = False
    each: bool = False
    drawn: bool = False
    words: frozenset[str] = frozenset()
    keys: bool = False
    instead: str = ""
    instead_of: frozenset[str] = frozenset({"obstacle", "fixed obstacle"})
    is_written: bool = False

    @property
    def takes_roles(self) -> bool:
        """Whether the name of a role may stand there, within a rule or the broadcast."""
        return (self.each or "spot" in self.kinds) and not self.keys and not self.is_written


@dataclass(frozen=True)
class SectionRef:
    """A reference to an entry of some sections: a counter, a phase, a kit.

    Attributes:
        words: names that exist without being defined.
        keys: True if the names are the keys of the mapping.
        numbers: of a draw the least and the greatest number that its values may be; None: they need not be numbers.
    """

    noun: str
    sections: tuple[str, ...]
    words: frozenset[str] = frozenset()
    keys: bool = False
    is_written: bool = False
    numbers: tuple[float, float] | None = None


@dataclass(frozen=True)
class DrawnValue:
    """Marks a field with a value of a draw: any text, but ``each`` and ``other`` stand for names.

    Attributes:
        is_set: whether the draw is set to it: then it must be one of its values, for whatever a name stands.
    """

    is_set: bool = False


Reference = Ref | SectionRef


def ref_of(model: type[BaseModel], field: str) -> Reference | None:
    """Return the reference of a model's field; None if it names nothing."""
    metadata = model.model_fields[field].metadata
    return next((extra for extra in metadata if isinstance(extra, Ref | SectionRef)), None)


def drawn_value(model: type[BaseModel], field: str) -> DrawnValue | None:
    """Return the mark of a field that has a value of a draw; None for any other."""
    return next((extra for extra in model.model_fields[field].metadata if isinstance(extra, DrawnValue)), None)


@cache
def refs_of(model: type[BaseModel]) -> list[tuple[str, str, Reference]]:
    """Return the fields of a model that name something: name, key in the file, and what it may name."""
    fields = ((name, info.alias or name, ref_of(model, name)) for name, info in model.model_fields.items())
    return [(name, key, reference) for name, key, reference in fields if reference is not None]


# --- what words name --------------------------------------------------------------------------------------------------

MOVING = frozenset({"robot", "ball", "obstacle"})
FIXED = frozenset({"fixed obstacle"})
KEEPING = MOVING | FIXED | {"zone", "gate"}
"""What a rule, a counter, a flag or a timer can be kept for, one each."""

_ROBOT, _ZONE, _GATE, _SPOT = frozenset({"robot"}), frozenset({"zone"}), frozenset({"gate"}), frozenset({"spot"})

ENTITIES = Ref("entity", MOVING, groups=True, each=True)
ENTITY = Ref("entity", MOVING, each=True)
ONE_ENTITY = Ref("entity", MOVING)
MEMBERS = Ref("entity", MOVING, groups=True)
THINGS = Ref("entity or obstacle", MOVING | FIXED, groups=True, each=True)
THING = Ref("entity or obstacle", MOVING | FIXED, each=True)
ROBOTS = Ref("robot", _ROBOT, groups=True, each=True)
ROBOT = Ref("robot", _ROBOT, each=True)
ONE_ROBOT = Ref("robot", _ROBOT)
ZONES = Ref("zone", _ZONE, groups=True, each=True, drawn=True)
GATES = Ref("gate", _GATE, groups=True, each=True, drawn=True)
SPOTS = Ref("spot", _SPOT, groups=True)
WRITTEN_SPOT = Ref("spot", _SPOT, is_written=True)
MEASURED_TO = Ref(
    "entity, obstacle, spot, zone or gate", MOVING | FIXED | _SPOT | _ZONE | _GATE, groups=True, each=True, drawn=True
)
SEEN = Ref("entity, obstacle or spot", MOVING | FIXED | _SPOT, each=True, drawn=True)
ANCHOR = Ref("entity or spot", MOVING | _SPOT, each=True, drawn=True)
ANCHORS = replace(ANCHOR, groups=True)
WHOSE = Ref("entity", KEEPING | {"entrant"}, each=True)
WHOSE_OF = replace(WHOSE, groups=True)
KEEPERS = Ref("entity, obstacle, zone or gate", KEEPING, groups=True)
ROLE_OF = Ref("entity, obstacle, spot, zone or gate", KEEPING | _SPOT, groups=True)
STEP = Ref("zone or gate", _ZONE | _GATE)

COUNTER = SectionRef("counter", ("counters",))
FLAG = SectionRef("flag", ("flags",))
TIMER = SectionRef("timer", ("timers",))
DRAW = SectionRef("draw", ("draws",))
ROLE = SectionRef("role", ("roles",))
PHASE = SectionRef("phase", ("phases",), words=frozenset({"play"}))
KEEP = replace(PHASE, words=PHASE.words | {"half", "match", "phase"})
SEQUENCE = SectionRef("sequence", ("sequences",))
ENTRANT = SectionRef("entrant", ("entrants",))
SCORED = replace(ENTRANT, words=frozenset({"each", "other", "others", "entrants"}))

WRITTEN_COUNTER, WRITTEN_FLAG, WRITTEN_TIMER, WRITTEN_DRAW, WRITTEN_ROLE, WRITTEN_SEQUENCE = (
    replace(one, is_written=True) for one in (COUNTER, FLAG, TIMER, DRAW, ROLE, SEQUENCE)
)
