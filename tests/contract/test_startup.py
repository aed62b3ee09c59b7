"""The way in: what ships, what it costs, and that an import watched is an import unchanged."""

from __future__ import annotations

import ast
import json
import os
import shutil
import subprocess
import sys
import tarfile
import time
import venv
import zipfile
from collections.abc import Iterator
from importlib import import_module
from pathlib import Path

import pytest

from glshim.bindings import imports
from glshim.running import launch

ROOT = Path(__file__).parents[2]
INSTALLED_AS = {"glshim": "glshim", "stylers": "glshim_stylers", "demo_apps": "glshim_demos"}
"""The folders that are packages, by the names under which they are installed."""
BESIDE_CODE = [
    path.relative_to(ROOT)
    for folder in INSTALLED_AS
    for path in (ROOT / folder).rglob("*")
    if path.suffix in (".glsl", ".toml", ".html", ".css", ".gcode", ".typed")
]
"""Files that the code reads when it runs."""
SILENT = {"GLSHIM_KEYS": "on", "GLSHIM_SAVE": "\n" * 5000}
"""Nothing is wrong with a folder until a picture is saved."""
LOADED = "import sys; print(*sorted(m for m in sys.modules if m.startswith(('glshim', '_glshim'))))"


def loaded(code: str, **variables: str) -> list[str]:
    """What of glshim a program has imported at its end."""
    done = subprocess.run(
        [sys.executable, "-c", f"{code}\n{LOADED}"], env={**os.environ, **variables},
        capture_output=True, text=True, timeout=60, check=True,
    )  # fmt: skip
    return done.stdout.split()


def test_with_no_variable_nothing_is_imported() -> None:
    assert loaded("pass") == []
    assert loaded("import OpenGL.GL") == []


def test_a_program_without_pyopengl_gets_the_watch_alone() -> None:
    expected = [  # "glshim" itself is hidden: see test_imports.py
        "glshim.bindings", "glshim.bindings.imports", "glshim.running", "glshim.running.startup",
        "glshim.system", "glshim.system.modules",
    ]  # fmt: skip
    assert loaded("pass", GLSHIM_STYLE="raskar") == expected
    assert "numpy" not in loaded("import json", GLSHIM_STYLE="raskar")


def test_importing_the_package_is_cheap() -> None:
    assert loaded("import glshim") == ["glshim"]


def test_every_public_name_is_there() -> None:
    import glshim

    for name in glshim.__all__:
        assert getattr(glshim, name) is not None
    assert set(glshim.__all__) <= set(dir(glshim))
    with pytest.raises(AttributeError, match="nonsense"):
        _ = glshim.nonsense


def test_checkers_of_types_see_the_same_names_from_the_same_homes() -> None:
    import glshim

    tree = ast.parse((ROOT / "glshim" / "__init__.py").read_text(encoding="utf-8"))
    seen = {
        alias.asname: node.module
        for node in ast.walk(tree)
        if isinstance(node, ast.ImportFrom) and node.module != "importlib"
        for alias in node.names
        if alias.name == alias.asname
    }
    assert seen == glshim._HOME_OF
    for name, home in seen.items():
        value = getattr(glshim, name)
        assert getattr(value, "__module__", home) in (home, "builtins", "typing", "types", "numpy")


@pytest.mark.parametrize("module", ["OpenGL.GL", "OpenGL.GLUT", "OpenGL.raw.GL.VERSION.GL_1_1"])
def test_a_style_comes_with_pyopengl(module: str) -> None:
    assert "glshim.pipeline" in loaded(f"import {module}", GLSHIM_STYLE="raskar")


def test_flags_that_the_app_sets_before_gl_still_count() -> None:
    code = (
        "import OpenGL; OpenGL.ERROR_CHECKING = False\n"
        "from OpenGL import GL, _configflags; assert not _configflags.ERROR_CHECKING"
    )
    assert "glshim.pipeline" in loaded(code, GLSHIM_STYLE="none")


def test_a_style_that_is_wrong_is_said_once_and_the_app_runs_plain() -> None:
    done = subprocess.run(
        [sys.executable, "-c", f"import OpenGL.GL, OpenGL.GLU\n{LOADED}"],
        env={**os.environ, "GLSHIM_STYLE": "rasker"}, capture_output=True, text=True, check=False,
    )  # fmt: skip
    assert done.returncode == 0
    assert done.stderr.count("\n") == 1
    assert "GLSHIM_STYLE: no style is called 'rasker': did you mean raskar?" in done.stderr
    assert "glshim.pipeline" not in done.stdout.split()


def test_the_interpreter_of_the_tests_reads_the_startup_file() -> None:
    assert launch.startup_file() is not None


def test_the_startup_files_hold_what_python_asks_of_them() -> None:
    lines = (ROOT / "glshim.pth").read_text(encoding="utf-8").splitlines()
    assert len(lines) == 1
    assert lines[0].startswith("import ")
    module, _, function = (ROOT / "glshim.start").read_text(encoding="utf-8").strip().partition(":")
    assert callable(getattr(import_module(module), function))


@pytest.fixture(scope="module")
def wheels(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The wheel of a copy of the sources, and the editable one with the archive of sources beside
    it, as pip builds them."""
    folder = tmp_path_factory.mktemp("wheels")
    source = folder / "source"
    ignored = shutil.ignore_patterns(".git", ".venv", "build", "out", "*.egg-info", ".*_cache")
    shutil.copytree(ROOT, source, ignore=ignored)
    build = [sys.executable, "-m", "pip", "wheel", "-q", "--no-deps", "-w"]
    subprocess.run([*build, str(folder), str(source)], check=True)
    code = (
        "import sys; sys.path.insert(0, 'scripts'); import build_backend; folder = sys.argv[1]; "
        "build_backend.build_editable(folder); build_backend.build_sdist(folder)"
    )
    (folder / "editable").mkdir()
    # pip has no command that only builds these; the hooks are what it calls.
    hook = [sys.executable, "-c", code, str(folder / "editable")]
    subprocess.run(hook, cwd=source, check=True, capture_output=True)
    return folder


def tops(names: set[str]) -> set[str]:
    """What a wheel puts into site-packages, but for its own record."""
    return {name.partition("/")[0] for name in names if ".dist-info/" not in name}


@pytest.mark.programs
def test_a_wheel_installed_by_itself_starts_glshim(wheels: Path, tmp_path: Path) -> None:
    (wheel,) = wheels.glob("*.whl")
    venv.create(tmp_path / "venv", with_pip=False)
    python = tmp_path / "venv" / "bin" / "python"
    asked = [str(python), "-c", "import sysconfig; print(sysconfig.get_path('purelib'))"]
    site_packages = subprocess.run(asked, capture_output=True, text=True, check=True).stdout.strip()
    with zipfile.ZipFile(wheel) as archive:
        names = set(archive.namelist())
        archive.extractall(site_packages)
        (record,) = (name for name in names if name.endswith("RECORD"))
        listed = {line.split(",")[0] for line in archive.read(record).decode().splitlines()}
    assert listed == names
    assert {"glshim.pth", "glshim.start", "_glshim_start.py", "glshim/py.typed"} <= names
    assert names >= {str(Path(INSTALLED_AS[p.parts[0]], *p.parts[1:])) for p in BESIDE_CODE}
    assert tops(names) == {"_glshim_start.py", "glshim.pth", "glshim.start", *INSTALLED_AS.values()}
    for variables, expected in (({}, False), ({"GLSHIM_STYLE": "raskar"}, True)):
        done = subprocess.run(
            [python, "-c", LOADED], env={"PATH": os.environ["PATH"], **variables},
            cwd=tmp_path, capture_output=True, text=True, check=True,
        )  # fmt: skip
        assert ("glshim.running.startup" in done.stdout.split()) == expected
        assert done.stderr == ""


@pytest.mark.programs
def test_the_archive_of_sources_holds_what_lies_beside_code(wheels: Path) -> None:
    (path,) = (wheels / "editable").glob("*.tar.gz")
    with tarfile.open(path) as archive:
        names = {name.partition("/")[2] for name in archive.getnames()}
    assert names >= {*map(str, BESIDE_CODE)}
    assert names >= {"glshim.pth", "glshim.start", "scripts/build_backend.py"}


@pytest.mark.programs
def test_an_editable_wheel_carries_the_startup_files_too(wheels: Path) -> None:
    (wheel,) = (wheels / "editable").glob("*.whl")
    names = set(zipfile.ZipFile(wheel).namelist())
    assert tops(names) == {"_glshim_start.py", "glshim.pth", "glshim.start", *INSTALLED_AS.values()}


@pytest.mark.parametrize("flag", ["-I", "-E"])
def test_python_that_ignores_the_environment_ignores_our_variables(flag: str) -> None:
    done = subprocess.run(
        [sys.executable, flag, "-c", f"import OpenGL.GL\n{LOADED}"],
        env={**os.environ, "GLSHIM_STYLE": "raskar", "GLSHIM_FRAMES": "1"},
        capture_output=True, text=True, check=True,
    )  # fmt: skip
    assert (done.stdout.split(), done.stderr) == ([], "")


def test_commands_do_not_start_programs_that_would_ignore_the_variables() -> None:
    command = [sys.executable, "-I", "-m", "glshim", "run", "-m", "this"]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    assert done.returncode == 2 and done.stdout == ""
    assert done.stderr.startswith("glshim: python -I and python -E ignore")
    assert done.stderr.count("\n") == 1


@pytest.mark.parametrize("function", ["geteuid", "getegid"])
def test_with_rights_of_another_no_file_is_run_and_none_is_written(
    tmp_path: Path, function: str
) -> None:
    mine = tmp_path / "mine.py"
    mine.write_text("raise SystemExit('was run')")
    variables = {
        "GLSHIM_STYLE": f"{mine}:Mine", "GLSHIM_CAPTURE": str(tmp_path / "a.png"),
        "GLSHIM_SHOT": "{}",
    }  # fmt: skip
    done = subprocess.run(
        [sys.executable, "-c", f"import os; os.{function} = lambda: 12345; import OpenGL.GL"],
        env={**os.environ, **variables}, capture_output=True, text=True, check=True,
    )  # fmt: skip
    assert done.stderr.splitlines() == [
        "glshim: setuid and setgid programs save no frames",
        f"glshim: GLSHIM_STYLE: {mine}: Python files are not run in a setuid or setgid program; "
        "the program runs unstyled",
    ]


@pytest.mark.parametrize(
    "variables",
    [
        {"GLSHIM_STYLE": "\n"}, {"GLSHIM_STYLE": "a\nb.toml"}, {"GLSHIM_STYLE": "x" * 100_000},
        {"GLSHIM_STYLE": "\udcff.toml"}, {"GLSHIM_STYLE": "/dev/zero.toml"},
        {"GLSHIM_STYLE": "é" * 300 + ".py:A"}, {"GLSHIM_FRAMES": "9" * 5000},
        {"GLSHIM_CAPTURE": "%0999999999d.png"}, {"GLSHIM_CAPTURE": ".png"},
        {"GLSHIM_CAPTURE": "%d%d.png"}, {"GLSHIM_CAPTURE": "é" * 200 + ".png"},
        {"GLSHIM_KEYS": "on=" * 5000}, {"GLSHIM_KEYS": "on", "GLSHIM_STYLES": "a,b=c\n"},
        {"GLSHIM_KEYS": "on", "GLSHIM_SAVE": "\n" * 5000},
        {"GLSHIM_FRAMES": "1", "GLSHIM_SHOT": "nonsense"},
    ],
    ids=lambda variables: ascii(variables)[:60],
)  # fmt: skip
def test_a_program_runs_on_under_odd_variables(variables: dict[str, str]) -> None:
    begin = time.monotonic()
    done = subprocess.run(
        [sys.executable, "-c", "import OpenGL.GL; print('runs')"],
        env={**os.environ, **variables}, capture_output=True, text=True, timeout=60, check=True,
    )  # fmt: skip
    assert done.stdout == "runs\n"
    said = done.stderr.splitlines()
    assert len(said) <= 1 and all(line.startswith("glshim: GLSHIM_") for line in said)
    assert bool(said) == (variables not in ({"GLSHIM_STYLE": "\n"}, SILENT))
    assert time.monotonic() - begin < 30.0


@pytest.fixture
def package(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[Path]:
    """A folder on sys.path for modules of a test."""
    monkeypatch.syspath_prepend(str(tmp_path))
    before = set(sys.modules)
    yield tmp_path
    for name in set(sys.modules) - before:
        del sys.modules[name]


def test_an_action_runs_before_the_importer_sees_a_name(package: Path) -> None:
    (package / "watched_a.py").write_text("def shown(): return 'plain'")
    (package / "user_a.py").write_text("from watched_a import shown")

    def action(module: object) -> None:
        module.shown = lambda: "hooked"  # type: ignore[attr-defined]

    imports.after_import("watched_a", action)
    assert import_module("user_a").shown() == "hooked"


def test_the_loader_stays_the_modules_own(package: Path) -> None:
    (package / "watched_b.py").write_text("value = 1")
    imports.after_import("watched_b", lambda module: None)
    module = import_module("watched_b")
    assert type(module.__loader__).__name__ == "SourceFileLoader"
    assert "exec_module" not in vars(module.__loader__)
    assert module.__spec__ is not None
    assert module.__spec__.loader is module.__loader__


def test_a_module_that_is_there_already_is_acted_on_now() -> None:
    seen: list[object] = []
    imports.after_import("json", seen.append)
    assert seen == [json]


def test_an_action_waits_for_an_import_under_way(package: Path) -> None:
    (package / "watched_c.py").write_text(
        "from glshim.bindings import imports\n"
        "seen = []\n"
        "imports.after_import('watched_c', lambda module: seen.append(module.end))\n"
        "end = 'reached'\n"
    )
    assert import_module("watched_c").seen == ["reached"]


def test_a_failing_import_fails_as_before_and_can_be_tried_again(package: Path) -> None:
    path = package / "watched_d.py"
    path.write_text("raise RuntimeError('first')")
    seen: list[object] = []
    imports.after_import("watched_d", seen.append)
    with pytest.raises(RuntimeError, match="first"):
        import_module("watched_d")
    path.write_text("value = 'a second version'")
    assert import_module("watched_d").value == "a second version"
    assert len(seen) == 1


def test_an_action_that_raises_breaks_no_import(
    package: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    (package / "watched_e.py").write_text("value = 1")

    def action(module: object) -> None:
        raise RuntimeError("in an action")

    imports.after_import("watched_e", action)
    assert import_module("watched_e").value == 1
    assert "in an action" in capsys.readouterr().err
