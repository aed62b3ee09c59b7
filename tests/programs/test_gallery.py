"""`glshim gallery`: pages that stand by themselves, runs that fail, and none left behind."""

import html
import json
import os
import re
import shutil
import signal
import subprocess
import sys
import time
from html.parser import HTMLParser
from pathlib import Path

import numpy as np
import pytest
from PIL import Image

from tests.programs.harness import ROOT

SPINNER = """
import sys, time, random
from OpenGL.GL import *
from OpenGL.GLUT import *
glutInit(); glutInitDisplayMode(GLUT_DOUBLE | GLUT_DEPTH); glutInitWindowSize(120, 90)
glutCreateWindow(b"x")
def show():
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT)
    glClearColor(time.time() * 7 % 1, random.random(), glutGet(GLUT_ELAPSED_TIME) % 100 / 100, 1)
    glEnable(GL_DEPTH_TEST)
    glutSolidCube(1.0)
    glutSwapBuffers()
glutDisplayFunc(show)
LOOP
glutMainLoop()
"""


class Links(HTMLParser):
    """What a page refers to."""

    def __init__(self, text):
        super().__init__()
        self.found = []
        self.feed(text)

    def handle_starttag(self, tag, attrs):
        self.found += [value for name, value in attrs if name in ("src", "href")]


def glshim(folder, *arguments, **more):
    return subprocess.run(
        [sys.executable, "-m", "glshim", *map(str, arguments)], cwd=folder, text=True,
        capture_output=True, timeout=120, check=False,
        env={**os.environ, "PYTHONPATH": str(ROOT)}, **more)


def script(folder, name, text):
    path = folder / name
    path.write_text(text)
    return path


def test_a_page_with_all_pictures_and_a_contact_sheet(tmp_path: Path) -> None:
    script(tmp_path, "spin ner.py", SPINNER.replace("LOOP", "glutIdleFunc(glutPostRedisplay)"))
    done = glshim(tmp_path, "gallery", "spin ner.py", "-o", "a page/out put.html",
                  "--styles", "none,raskar:ink=#ff0000,silhouette_width=3,none:", "--columns", "2")
    assert done.returncode == 0, done.stderr
    assert "spin ner.py: 100%" in done.stderr  # the progress bar
    page = tmp_path / "a page" / "out put.html"
    links = Links(page.read_text("utf-8")).found
    pictures = sorted(page.with_name("out put_files").glob("*.png"))
    assert len(pictures) == 3
    for link in links:
        assert not re.match(r"\w+:|/", link), link  # nothing from elsewhere
        assert (page.parent / link.replace("%20", " ")).is_file(), link
    plain, again, raskar = (np.asarray(Image.open(picture)) for picture in pictures)
    assert plain.shape == (90, 120, 3) and (plain == again).all()  # the same moment and luck
    red = (raskar == (255, 0, 0)).all(axis=2)
    assert red.sum() > 200 and (plain != raskar).any(axis=2).sum() >= red.sum()
    sheet = Image.open(page.with_suffix(".png"))
    assert sheet.width > 2 * 400 and sheet.height > 2 * 300


BROWSER = shutil.which("chromium") or shutil.which("google-chrome")
USE = """<script>
addEventListener("load", () => {
  const found = {}, shown = () => [...document.querySelectorAll("figure")]
    .filter(figure => figure.offsetParent).map(figure => figure.querySelector("h2").textContent);
  const wide = () => [...document.querySelectorAll("body *")]
    .filter(each => each.getBoundingClientRect().right > innerWidth + 1).length;
  const input = document.querySelector("input");
  found.all = shown();
  document.querySelectorAll("details").forEach(each => each.open = true);
  found.wide = [innerWidth, wide()];
  document.dispatchEvent(new KeyboardEvent("keydown", {key: "/"}));
  found.focused = document.activeElement === input;
  input.value = "KAR ras"; input.dispatchEvent(new Event("input"));
  found.typed = [shown(), document.querySelector("output").textContent];
  document.dispatchEvent(new KeyboardEvent("keydown", {key: "Escape"}));
  document.querySelector("button[value=paper]").click();
  found.paper = shown();
  input.value = "zebra"; input.dispatchEvent(new Event("input"));
  found.none = [shown(), document.querySelector(".nothing").hidden];
  document.title = JSON.stringify(found);
});
</script>"""


def page_of_four(folder: Path) -> Path:
    """A page without any program."""
    from glshim.running.gallery.page import write_page
    from glshim.running.gallery.runs import styled
    from glshim.running.gallery.tiles import tile

    picture = folder / "picture.png"
    Image.new("RGB", (40, 30), "#804020").save(picture)
    tiles = [tile(styled(name, name, 3, picture), "gears <1>.py")
             for name in ("none", "raskar", "edge_mesh", "charcoal")]
    write_page(folder / "page.html", "gears <1>.py", tiles, 4, picture)
    return folder / "page.html"


def test_a_page_is_described_and_shows_all_without_scripts(tmp_path: Path) -> None:
    text = page_of_four(tmp_path).read_text("utf-8")
    assert 'alt="gears &lt;1&gt;.py in style raskar: ' in text
    assert 'alt="gears &lt;1&gt;.py without a style"' in text and "<h2>none</h2>" in text
    assert re.search(r'<form class="filter"[^>]* hidden>', text)  # a script shows it
    assert not re.search(r"<figure[^>]* hidden", text)
    assert '<h2>charcoal</h2>' in text and "<dt class=changed><code>paper</code>" in text


@pytest.mark.skipif(BROWSER is None, reason="no Chromium to open the page with")
@pytest.mark.parametrize("width", [500, 1400])  # Chromium's windows are no narrower
def test_tiles_are_filtered_by_words_and_by_category(tmp_path: Path, width: int) -> None:
    page = page_of_four(tmp_path)
    page.write_text(page.read_text("utf-8") + USE, "utf-8")
    done = subprocess.run(
        [BROWSER, "--headless=new", "--no-sandbox", "--disable-gpu", f"--window-size={width},900",
         f"--user-data-dir={tmp_path / 'profile'}", "--dump-dom", page.as_uri()],
        capture_output=True, text=True, timeout=120, check=True)
    title = re.search("<title>(.*?)</title>", done.stdout, re.DOTALL)
    assert title is not None, done.stderr
    assert json.loads(html.unescape(title[1])) == {
        "all": ["none", "raskar", "edge_mesh", "charcoal"], "focused": True,
        "wide": [width, 0], "typed": [["raskar"], "1 of 4 shown"], "paper": ["charcoal"],
        "none": [[], False],
    }


def test_two_styles_under_a_slider(tmp_path: Path) -> None:
    done = glshim(tmp_path, "gallery", "cube", "--compare", "none", "raskar", "-o", "both.html")
    assert done.returncode == 0, done.stderr
    text = (tmp_path / "both.html").read_text("utf-8")
    links = Links(text).found
    assert {"both_files/none.png", "both_files/raskar.png"} <= set(links)
    assert 'type="range"' in text and "aria-label" in text
    assert not any(":" in link for link in links)
    shapes = {Image.open(tmp_path / "both_files" / f"{name}.png").size
              for name in ("none", "raskar")}
    assert len(shapes) == 1


def test_a_program_that_draws_on_demand_is_asked_again(tmp_path: Path) -> None:
    script(tmp_path, "still.py", SPINNER.replace("LOOP", ""))
    done = glshim(tmp_path, "gallery", "still.py", "--styles", "none", "--frame", "5")
    assert done.returncode == 0, done.stderr
    assert (tmp_path / "gallery_files" / "none.png").is_file()


def test_a_run_that_fails_is_a_tile_that_says_why(tmp_path: Path) -> None:
    script(tmp_path, "broken.py", "import os\nif 'raskar' in os.environ['GLSHIM_STYLE']:\n"
           "    raise SystemExit('no <paint> left')\n" + SPINNER.replace("LOOP", ""))
    done = glshim(tmp_path, "gallery", "broken.py", "--styles", "none,raskar")
    assert done.returncode == 1
    assert "raskar: the program exited with status 1: no <paint> left" in done.stderr
    text = (tmp_path / "gallery.html").read_text("utf-8")
    assert "no &lt;paint&gt; left" in text and "1 failed" in text
    script(tmp_path, "slow.py", "import OpenGL.GL\nwhile True: pass\n")
    done = glshim(tmp_path, "gallery", "slow.py", "--styles", "none", "--timeout", "2")
    assert done.returncode == 1 and "timed out after 2 s with no frame" in done.stderr


@pytest.mark.parametrize(
    ("arguments", "says"),
    [(["nothing.py"], "no file or built-in shape is named nothing.py"),
     (["cube", "--styles", "rasker"], "raskar"),
     (["lost.obj"], "no such model file: lost.obj"), ([], "nothing to show"),
     (["cube", "-o", "out.pdf"], "must end in .html"), (["cube", "--frame", "0"], "whole number"),
     (["cube", "--columns", "0"], "greater than zero"),
     (["cube", "--jobs", "0"], "greater than zero")],
)  # fmt: skip
def test_a_command_that_makes_no_sense_ends_before_any_run(
    tmp_path: Path, arguments: list[str], says: str
) -> None:
    done = glshim(tmp_path, "gallery", *arguments)
    assert done.returncode == 2 and says in done.stderr
    assert "Traceback" not in done.stderr and not list(tmp_path.iterdir())


def test_a_class_in_a_file_beside_the_program_has_its_tile(tmp_path: Path) -> None:
    page = (ROOT / "docs" / "guide" / "writing_a_styler.md").read_text()
    script(tmp_path, "my.py", page.split("```python\n")[1].split("```")[0])
    done = glshim(tmp_path, "gallery", script(tmp_path, "app.py", SPINNER.replace("LOOP", "")),
                  "--styles", "none,my.py:Glow", "--frame", "1", "-o", "o.html")
    assert (done.returncode, done.stdout) == (0, f"{tmp_path / 'o.html'}\n"), done.stderr
    assert len(list((tmp_path / "o_files").glob("*.png"))) == 2
    assert "my.py:Glow" in (tmp_path / "o.html").read_text()


def test_what_is_not_a_page_or_a_picture_is_not_overwritten(tmp_path: Path) -> None:
    app = script(tmp_path, "app.py", SPINNER.replace("LOOP", ""))
    once = ["gallery", app, "--styles", "none", "--frame", "1", "-o", "o.html"]
    for name in ("o_files/none.png", "o.png", "o.html"):
        assert glshim(tmp_path, *once).returncode == 0
        (tmp_path / name).write_text("mine")
        done = glshim(tmp_path, *once)
        assert done.returncode == 2
        assert f"cannot write {tmp_path / name}: " in done.stderr
        assert "remove it first" in done.stderr
        assert name.startswith("o_files") or "style/s" not in done.stderr  # before any run
        assert done.stderr.count("glshim: ") == 1 and "Traceback" not in done.stderr
        assert (tmp_path / name).read_text() == "mine"
        (tmp_path / name).unlink()


def test_ctrl_c_leaves_no_process_behind(tmp_path: Path) -> None:
    mark = f"endless_{os.getpid()}.py"
    script(tmp_path, mark, "import subprocess, sys, time\nimport OpenGL.GL\n"
           "wait = 'import signal; signal.pause()'\n"
           "subprocess.Popen([sys.executable, '-c', wait, sys.argv[0]])\nexec(wait)\n")
    with subprocess.Popen(
        [sys.executable, "-m", "glshim", "gallery", mark, "--styles", "none,raskar,crease",
         "--timeout", "40", "--jobs", "2"],
        cwd=tmp_path, stderr=subprocess.PIPE, text=True,
        env={**os.environ, "PYTHONPATH": str(ROOT)},
        # As in a terminal: what runs in the background has it ignored.
        preexec_fn=lambda: signal.signal(signal.SIGINT, signal.SIG_DFL),  # noqa: PLW1509
    ) as gallery:
        deadline = time.monotonic() + 30
        while len(running(mark)) < 5 and time.monotonic() < deadline:  # ours, two, and theirs
            time.sleep(0.1)
        assert len(running(mark)) >= 5
        gallery.send_signal(signal.SIGINT)
        assert gallery.stderr is not None
        said = gallery.stderr.read()
        assert gallery.wait(20) == 130
    assert "interrupted; the pictures made so far are in" in said and "Traceback" not in said
    time.sleep(0.2)
    assert running(mark) == []


def running(mark: str) -> list[int]:
    """Processes whose command line holds a mark."""
    found = []
    for entry in Path("/proc").glob("[0-9]*/cmdline"):
        try:
            if mark.encode() in entry.read_bytes():
                found.append(int(entry.parent.name))
        except OSError:
            continue
    return found
