"""Which lines of a decision the window tells: all of a few rules, the nearest of many."""

from phonemeanalyser.colours import LIGHT
from phonemeanalyser.desktop.analyse.recognition.phoneme_view import N_ROWS, PhonemeView, rows_of
from phonemeengine.phonemes import Phoneme
from phonemeengine.recognition.scores import RuleComparison, Trace
from tests.conftest import ROOT

DEMO = ROOT / "phonemeanalyser" / "demo" / "demo.flac"


def compared(rule: str, margin: float, limit: float = 1.0, variable: str = "energy") -> RuleComparison:
    return RuleComparison(rule, variable, limit + margin, ">", "", limit, margin)


def test_of_few_rules_each_one_is_told_by_the_first_comparison_that_failed() -> None:
    held, first, second = compared("a 1", 0.5), compared("a 1", -0.25), compared("a 1", -2.0)
    fired = compared("o", 0.125)
    trace = Trace(Phoneme.O, "o", (held, first, second, fired))
    assert rows_of(trace) == [(first, "a 1", False), (fired, "o", True)]


def test_of_many_rules_those_are_told_that_nearly_held() -> None:
    shares = [0.5, 0.01, 0.9, 0.02, 0.8, 0.03, 0.7, 0.04, 0.6, 0.05, 0.65, 0.06]
    failed = [compared(f"e {k}", -100 * share, 100.0) for k, share in enumerate(shares)]
    fired = [compared("o", 1.0, variable=f"b{k}") for k in range(4)]
    rows = rows_of(Trace(Phoneme.O, "o", (*failed, *fired)))
    assert len(rows) == N_ROWS
    assert [rule for _, rule, _ in rows] == ["e 1", "e 3", "e 5", "e 7", "e 9", "e 11", *4 * ["o"]]


def test_a_rule_is_as_near_as_its_worst_comparison() -> None:
    near = [compared(f"e {k}", -0.25) for k in range(N_ROWS)]
    far = (compared("u", -0.01), compared("u", -0.75))
    rows = rows_of(Trace(Phoneme.O, "o", (*far, *near, compared("o", 1.0))))
    assert "u" not in {rule for _, rule, _ in rows}
    assert len(rows) == N_ROWS


def test_a_rule_of_many_comparisons_leaves_no_room_for_others() -> None:
    fired = tuple(compared("o", 1.0, variable=f"b{k}") for k in range(N_ROWS + 2))
    rows = rows_of(Trace(Phoneme.O, "o", (compared("a", -1.0), *fired)))
    assert [c for c, _, _ in rows] == list(fired[:N_ROWS])


def test_the_trace_names_the_comparison_that_turns_most_where_the_phoneme_flickers(session, play):
    session.open(DEMO)
    view = PhonemeView(session, LIGHT)
    flickers = []
    for _ in range(150):
        play(0.02)
        view.refresh()
        flickers.append(view.flicker)
    assert flickers[0] == ""
    told = [words for words in flickers if words]
    assert told
    assert all(words.startswith("Changes often: ") for words in told)
    assert max(int(words.split(" of ")[-1].split()[0]) for words in told) > 10
    assert len(rows_of(view.trace, N_ROWS - 1)) <= N_ROWS - 1


def test_a_comparison_has_turned_whose_answer_is_another_than_before() -> None:
    def trace(*margins: float) -> Trace:
        names = "energy", "volume"
        compared = (RuleComparison("a", n, 0, "<", f"{n}_limit", 0, m) for n, m in zip(names, margins, strict=True))
        return Trace(Phoneme.A, "a", tuple(compared))

    assert trace(1, 1).turned_since(trace(2, 3)) is None
    turned = trace(1, -1).turned_since(trace(2, 3))
    assert turned is not None
    assert (turned.variable, turned.margin) == ("volume", -1)
