"""Programs of public repositories: what is absent is named, what is there is started."""

from pathlib import Path

from .checkouts import CHECKOUTS, starts_from
from .sources import Launch, SourceMissing


def test_names_are_of_one_program_each() -> None:
    assert len({checkout.program().slug for checkout in CHECKOUTS}) == len(CHECKOUTS) >= 20


def test_what_is_absent_is_skipped_with_the_reason(tmp_path: Path) -> None:
    reasons = list(starts_from(tmp_path).values())
    assert all(isinstance(reason, SourceMissing) for reason in reasons)
    assert "github.com/AhmetServet/3DRoomWithPyOpenGL at 14229ac" in str(reasons[0])


def test_a_clone_is_started_in_its_folder_by_our_helper_where_it_needs_one(tmp_path: Path) -> None:
    repository = "FaisalIf/CSE423-Computer-Graphics-Project"
    clone = tmp_path / repository.replace("/", "+")
    clone.mkdir()
    clone.joinpath("main.py").touch()
    start = next(start for program, start in starts_from(tmp_path).items()
                 if program.source == repository)
    assert isinstance(start, Launch)
    assert (start.folder, start.command[1:]) == (clone, ("n", "main.py"))
    assert start.command[0].endswith("keys_first.py") and Path(start.command[0]).is_file()


def test_a_module_that_neither_python_nor_the_folder_has_is_named(tmp_path: Path) -> None:
    (tmp_path / "wxWidgets+Phoenix" / "samples" / "glcanvas").mkdir(parents=True)
    tmp_path.joinpath("wxWidgets+Phoenix", "samples", "glcanvas", "GLCanvas.py").touch()
    before = {program.name: start for program, start in starts_from(tmp_path).items()}
    (tmp_path / "site" / "wx").mkdir(parents=True)
    tmp_path.joinpath("site", "wx", "__init__.py").touch()
    after = {program.name: start for program, start in starts_from(tmp_path).items()}
    assert isinstance(after["wx cube"], Launch)
    assert after["wx cube"].paths == (tmp_path / "site",)
    assert isinstance(before["wx cube"], Launch) or "has wx" in str(before["wx cube"])
