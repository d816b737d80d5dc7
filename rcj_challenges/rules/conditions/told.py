"""What is particular to the condition ``told``."""

from rcj_challenges.rules.base import Binder, Phrases, Test
from rcj_challenges.rules.comparison import Compared
from rcj_challenges.rules.message import Message
from rcj_challenges.rules.number import NumberValue
from rcj_challenges.rules.values.reported import ReportedValue


class ToldIs(Compared, Message, ReportedValue):
    """A robot's last message to the referee in this half; the condition does not hold before the first one.

    Without a comparison: whether it has sent one, and it is what `text` and `is_a` require.
    """

    VALUE = ReportedValue
    REQUIRES = ()
    EXCLUDES = (*Compared.EXCLUDES, ("text", ("at_least", "at_most", "above", "below", "equals")))
    EXAMPLE = ReportedValue.EXAMPLE

    def test(self, to: Binder) -> Test:
        if self.limits():
            return super().test(to)
        messages, fits = to.state.messages, self.matcher(to.state.draws)

        def has_told(value: NumberValue) -> Test:
            (robot,) = to.members(value.named())
            return lambda: robot in messages and fits(messages[robot])

        return self.test_of_each(to, has_told)

    def describe(self, phrases: Phrases) -> str:
        if self.limits():
            return super().describe(phrases)
        subject, said = phrases.quantified(self.of or "any", self.told, negate=self.negate), self.said(phrases)
        if not said:
            return f"{subject.does('was', 'were')} heard by the referee before"
        their = "their" if subject.plural else "its"
        return f"{subject.does('has', 'have')} {said} as {their} last message to the referee"
