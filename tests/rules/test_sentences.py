"""The rule sheet describes each word, as the reference shows it beside the example."""

import pytest

from rcj_challenges.rules.base import Word
from scripts.sheet_sentences import sheet_sentences
from scripts.write_reference import CHAPTERS, PAGE, example_of, read_examples

WORDS = [
    (chapter, word)
    for chapter in CHAPTERS
    for word in chapter.words
    if issubclass(word.model, Word) and word.own_example
]


@pytest.mark.parametrize(("chapter", "word"), WORDS, ids=[f"{one.title}-{word.name}" for one, word in WORDS])
def test_a_word_of_an_example_is_described_as_in_the_reference(chapter, word):
    sentences = sheet_sentences(word.model, chapter.file, example_of(word, chapter, read_examples()).whole)
    assert sentences
    assert "\n\nOn the rule sheet:\n\n" + "\n".join(f"* {one}" for one in sentences) in PAGE.read_text("utf-8")
