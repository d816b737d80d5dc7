"""The list that the words of conditions are added to; conditions that are made of others need it before it is full."""

from rcj_challenges.rules.base import Vocabulary

CONDITIONS = Vocabulary("condition")
