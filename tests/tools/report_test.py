# SPDX-License-Identifier: GPL-3.0-or-later
"""hybrid report: one file that tells the truth about a run, looked at in a browser at the widths of a phone and a desk."""
import html.parser
import re

import h5py
import numpy as np
import pytest
import tool
from conftest import ONE_RUN, ROOT
from selenium import webdriver

from hybrid_run import Run
from hybrid_run.parameters import changed_parameters
from hybrid_tools.report import costs, errors, facts, panels, vector

WIDTHS = {"phone": 390, "desk": 1280}

# What lies outside of the box that it should be in: blocks wider than their own box, letters of drawings outside of the drawing.
OVERFLOWING = """
const wide = [...document.querySelectorAll("h1,h2,h3,p,li,dt,dd,figcaption,summary,footer,nav")]
  .filter(e => e.scrollWidth > e.clientWidth + 1 && e.clientWidth > 0).map(e => e.tagName + ": " + e.textContent.slice(0, 40));
const letters = [...document.querySelectorAll("svg")].flatMap(svg => { const box = svg.getBoundingClientRect();
  return [...svg.querySelectorAll("text")].filter(t => { const r = t.getBoundingClientRect();
    return r.left < box.left - 2 || r.right > box.right + 2 || r.top < box.top - 2 || r.bottom > box.bottom + 2; }).map(t => t.textContent); });
return wide.concat(letters);
"""
HIDDEN = "return [...document.querySelectorAll('svg, img')].filter(e => e.getBoundingClientRect().width < 50 || e.getBoundingClientRect().height < 30).length"


class Page(html.parser.HTMLParser):
    """Identifiers, links, what is fetched and what is drawn."""

    VOID = {"meta", "link", "br"}

    def __init__(self, text):
        super().__init__()
        self.ids, self.links, self.fetched, self.drawings, self.tags, self.open, self.words = [], [], [], [], [], [], []
        self.feed(text)

    def handle_starttag(self, tag, attributes):
        found = dict(attributes)
        self.tags.append(tag)
        if tag not in self.VOID:
            self.open.append(tag)
        if "id" in found:
            self.ids.append(found["id"])
        for name in ("href", "xlink:href", "src"):
            if name in found:
                (self.links if found[name].startswith("#") else self.fetched).append(found[name])
        if tag == "svg":
            self.drawings.append(found)

    def handle_startendtag(self, tag, attributes):
        self.handle_starttag(tag, attributes)
        if tag not in self.VOID:
            self.open.pop()

    def handle_endtag(self, tag):
        assert self.open.pop() == tag

    def handle_data(self, data):
        self.words.append(data)

    @property
    def text(self):
        return " ".join(" ".join(self.words).split())


def check_file(path):
    """Nothing is fetched, no script runs, links have their ends, identifiers are unique, drawings have words and a size."""
    text = path.read_text(encoding="utf-8")
    page = Page(text)
    assert not page.open and "script" not in page.tags
    assert all(link.startswith("data:") for link in page.fetched), page.fetched
    assert not re.search(r"url\((?!#)|@import", text)
    assert len(set(page.ids)) == len(page.ids) and {link[1:] for link in page.links} <= set(page.ids)
    assert page.drawings and all(len(found["aria-label"]) > 10 and float(found["width"]) > 50 and float(found["height"]) > 30 for found in page.drawings)
    return page


@pytest.fixture(scope="module")
def browser():
    options = webdriver.ChromeOptions()
    options.binary_location = "/usr/bin/chromium"
    for word in ("--headless=new", "--no-sandbox", "--disable-gpu", "--disable-dev-shm-usage"):
        options.add_argument(word)
    options.set_capability("goog:loggingPrefs", {"browser": "ALL"})
    driver = webdriver.Chrome(service=webdriver.chrome.service.Service("/usr/bin/chromedriver"), options=options)
    yield driver
    driver.quit()


def look_at_paper(driver):
    """The page that is shown, as it is printed on A4 with margins: nothing is cut off."""
    driver.execute_cdp_cmd("Emulation.setDeviceMetricsOverride", {"width": 700, "height": 1000, "deviceScaleFactor": 1, "mobile": False})
    driver.execute_cdp_cmd("Emulation.setEmulatedMedia", {"media": "print"})
    assert driver.execute_script("return document.documentElement.scrollWidth") <= 700
    driver.execute_cdp_cmd("Emulation.setEmulatedMedia", {"media": ""})


shown = []  # the page in the browser: another width needs no other start


def look(driver, path, width, scheme="light"):
    """Show the page; it must fit and say nothing in the console."""
    driver.execute_cdp_cmd("Emulation.setDeviceMetricsOverride", {"width": width, "height": 844, "deviceScaleFactor": 1, "mobile": width < 500})
    driver.execute_cdp_cmd("Emulation.setEmulatedMedia", {"features": [{"name": "prefers-color-scheme", "value": scheme}]})
    if shown != [path]:
        driver.get("file://%s" % path)
        shown[:] = [path]
    assert driver.get_log("browser") == []
    assert driver.execute_script("return document.documentElement.scrollWidth <= innerWidth && innerWidth") == width
    assert driver.execute_script(OVERFLOWING) == []
    assert driver.execute_script(HIDDEN) == 0
    assert driver.execute_script("return performance.getEntriesByType('resource').length") == 0


@pytest.fixture(scope="module")
def column(hybrid, tmp_path_factory):
    directory = tmp_path_factory.mktemp("column") / "run <1> & co"
    result = hybrid(ROOT / "parameters/verification/coupled_column.prm", "-s", "Time/End time=0.3", "-s", "Heterogeneity/Modulus shape=3",
                    "-s", f"Output/Directory={directory}")
    assert result.returncode == 0, result.stderr
    return directory


def test_a_run_of_the_program(hybrid, column, browser):
    result = hybrid("report", column)
    path = column / "report.html"
    assert result.returncode == 0 and result.stdout.startswith(f"report: {path}, "), result.stderr
    page = check_file(path)
    run = Run(column)
    assert f"Finished: 0.3 s in {run.summary['steps']} steps" in page.text and "End time 0.3 1" in page.text  # value and default
    for name, monitor in run.monitors.items():
        assert "%.3g" % monitor.peak().max() in page.text
    spread = run.get("heterogeneity/modulus_factor")
    assert "distribution of shape 3, seed 1; %d values from %.2g to %.2g" % (len(spread), spread.min(), spread.max()) in page.text
    assert {"r1-random", "r1-cost"} <= set(page.ids) and "{:,} steps of %.3g iterations".format(run.summary["steps"]) % (
        run.summary["iterations"] / run.summary["steps"]) in page.text
    for warning in facts.warnings(run):
        assert " ".join(warning.split()) in page.text
    assert {"r1-summary", "r1-motion", "r1-monitors", "r1-velocities", "r1-histories", "r1-card", "r1-parameters"} <= set(page.ids)
    for width in WIDTHS.values():
        look(browser, path, width)
    look_at_paper(browser)
    look(browser, path, WIDTHS["desk"], "dark")
    dark = browser.execute_script("return getComputedStyle(document.body).backgroundColor")
    assert sum(map(int, re.findall(r"\d+", dark)[:3])) < 150
    before = path.read_text()
    assert tool.main("report", [str(column)]) == 0 and path.read_text() == before  # same run, same page


def test_a_long_run_of_many_monitors_stays_small_and_fits(synthetic_run, browser):
    directory = synthetic_run("complete")
    with h5py.File(directory / "run.h5", "r+") as file:  # as rough as it can be: noise in every step
        rng = np.random.default_rng(5)
        for group in (file["monitors"], file["filtered/monitors"]):
            for name in group:
                for quantity in group[name]:
                    group[name][quantity][:] += 0.2 * np.abs(group[name][quantity][:]).max() * rng.standard_normal(group[name][quantity].shape)
    assert tool.main("report", [str(directory)]) == 0
    path = directory / "report.html"
    page = check_file(path)
    assert path.stat().st_size < 3e6 and len(page.drawings) > 20
    for width in WIDTHS.values():
        look(browser, path, width)
    look_at_paper(browser)


def test_two_runs_are_compared(hybrid, column, tmp_path, browser):
    other = tmp_path / "finer"
    result = hybrid(ROOT / "parameters/verification/coupled_column.prm", "-s", "Time/End time=0.2", "-s", "Time/Time step=5e-4", "-s", f"Output/Directory={other}",
                    *ONE_RUN)
    assert result.returncode == 0, result.stderr
    path = tmp_path / "both.html"
    assert tool.main("report", [str(column), str(other), "--output", str(path)]) == 0
    page = check_file(path)
    assert {"compared", "r1", "r2", "r1-monitors", "r2-monitors"} <= set(page.ids) and "Time/Time step" in page.text
    for width in WIDTHS.values():
        look(browser, path, width)
    look_at_paper(browser)


def test_what_a_run_lacks_is_left_out(synthetic_run, tmp_path):
    runs = [synthetic_run("bare", "one"), synthetic_run("complete", "two")]
    assert tool.main("report", [str(runs[0])]) == 0
    page = check_file(runs[0] / "report.html")
    assert "goes on, or was killed" in page.text and not {"r1-slip", "r1-failure"} & set(page.ids) and "r1-histories" in page.ids


def test_how_a_mass_fails_is_shown(hybrid, tmp_path, browser):
    words = ["-s", f"Output/Directory={tmp_path}/run", "-s", "Output/Picture interval=0.05", *ONE_RUN]
    result = hybrid(ROOT / "parameters/hard/all_joints_fail.prm", *words)
    assert result.returncode == 0, result.stderr
    assert tool.main("report", [f"{tmp_path}/run"]) == 0
    assert "r1-failure" in check_file(tmp_path / "run/report.html").ids
    for width in WIDTHS.values():
        look(browser, tmp_path / "run/report.html", width)


def test_changed_parameters_and_their_defaults(tmp_path):
    path = tmp_path / "params.used.prm"
    path.write_text("set Title = a # default: \nsubsection Time\n  set End time = 3 # default: 1\n  set Time step = 0.001\nend\n")
    assert changed_parameters(path) == {"Title": ("a", ""), "Time/End time": ("3", "1")}


def test_parts_of_the_time_are_the_whole_run(column):
    run = Run(column)
    parts = costs.parts_of(run)
    assert sum(parts.values()) == pytest.approx(run.summary["wall_time_s"], rel=2e-3)
    assert parts["output"] == run.summary["timings_s"]["output"] and all(seconds >= 0 for seconds in parts.values())
    assert sum(float(row[2]) for row in costs.rows_of(run)) == pytest.approx(100, abs=2)


def test_each_number_of_the_first_screen_says_of_what_it_is(column):
    found = facts.facts(Run(column))
    assert len({fact.name for fact in found}) == len(found) and not any("argest" in fact.name for fact in found)
    assert all(fact.more for fact in found)


def test_a_thinned_history_keeps_its_peaks():
    x = np.linspace(0, 12, 12000)
    y = np.random.default_rng(1).standard_normal(12000)
    few, kept = vector.thinned(x, y)
    assert len(few) <= 1600 and kept.max() == y.max() and kept.min() == y.min() and few[0] == x[0] and few[-1] == x[-1]
    assert np.array_equal(np.interp(few, x, y), kept)
    pieces = y[:11900].reshape(-1, 17)  # 12000 // 700 = 17 in each
    there = np.array([[kept[(few >= x[17 * k]) & (few <= x[17 * k + 16])].min(), kept[(few >= x[17 * k]) & (few <= x[17 * k + 16])].max()]
                      for k in range(0, 700, 20)])
    assert np.array_equal(there, np.column_stack([pieces.min(axis=1), pieces.max(axis=1)])[::20])
    assert np.array_equal(vector.thinned(y, y)[0], y)  # no history: x goes back and forth


def test_numbers_lose_only_what_nobody_sees():
    assert vector.rounded("M 10.26 -0.04 L 3.999 20.0 12", 1) == "M 10.3 0 L 4 20 12"
    svg = '<?xml?><svg xmlns="http://www.w3.org/2000/svg" width="9pt" viewBox="0 0 100.5 60"><g id="a"><path id="b" d="M 1.26 2"/></g><use href="#b"/></svg>'
    small = vector.shrunk(svg, "n", 'what "it" shows')
    assert 'id="n-b"' in small and 'href="#n-b"' in small and 'id="a"' not in small and 'd="M 1.3 2"' in small and "&#34;it&#34;" in small


@pytest.mark.parametrize("words, part", [([], "RUN"), (["nowhere"], "'nowhere' is not a directory"), (["run", "--outptu", "x"], "did you mean '--output'?")])
def test_mistakes_are_one_line(tmp_path, monkeypatch, capsys, words, part):
    monkeypatch.chdir(tmp_path)
    assert tool.main("report", words) == 2
    said = capsys.readouterr().err
    assert part in said and said.startswith("error: ") and said.count("\n") == 1, said


def test_ratios_are_shown_where_the_motion_has_energy(column):
    run = Run(column)
    frequency, ratio = next(iter(run.monitors.values())).spectral_ratio()
    assert np.isfinite(ratio).any()
    time, acceleration = run.equal_steps(run.history("input/acceleration"))
    amplitude = np.abs(np.fft.rfft(acceleration[:, 0]))
    quiet = frequency > 3 * np.fft.rfftfreq(len(time), time[1] - time[0])[amplitude > 1e-3 * amplitude.max()].max()
    assert np.isnan(ratio[quiet]).all()


def test_peaks_are_compared_with_the_outcrop_motion_in_its_direction(synthetic_run):
    directory = synthetic_run("complete")
    with h5py.File(directory / "run.h5", "a") as file:
        name = next(name for name in file["monitors"] if name != Run(directory).base)
        file["filtered/monitors/%s/acceleration" % name][:, 1] *= 1e4
    run = Run(directory)
    outcrop = np.abs(run.history("input/acceleration")).max(axis=0)
    k = outcrop.argmax()
    row = next(row for row in facts.monitor_rows(run)[1] if row[0] == name)
    peaks = run.monitors[name].peak()
    assert k == 0 and peaks[1] > 10 * peaks[0]
    assert row[3] == "%.3g" % peaks[1] and row[4] == "%.2f" % (peaks[0] / outcrop[0])


def test_errors_are_those_of_the_summary():
    def error(value, slip=None):
        parts = {name: {"part_of_peak": value, "monitor": "crest"} for name in errors.QUANTITIES}
        return dict(parts, slip_left={"part": slip})

    class Finished:
        summary = {"blocks": 8, "probable_error": {"estimated": True, "measured_from_time_step_s": 0.002, "until_s": 1.25,
                                                   "time_step": error(0.012, 0.03), "half_the_step": error(0.003), "bedrock_mesh": error(None)},
                   "mesh_error": {"estimated": False, "reason": "the next mesh is hardly coarser"}}

    rows = errors.rows_of(Finished)
    assert [len(row) for row in rows] == [len(errors.HEAD)] * 3
    assert rows[0] == ["of the time step"] + ["1.2 (crest)"] * 3 + ["3", "a run in steps of 0.002 s, until a joint failed at 1.25 s"]
    assert rows[1][0] == "with half of it" and rows[1][1] == "0.3 (crest)"
    for both, words in ((1.25, "1.25 s"), (1.257, "1.25 s (by 1.257 s in both runs)"), (None, "1.25 s (not yet in one of both runs)")):
        Finished.summary["probable_error"]["failed_in_both_by_s"] = both
        assert errors.rows_of(Finished)[0][-1].endswith("failed at " + words)
    assert rows[2][-1] == "not known: the next mesh is hardly coarser"
    Finished.summary["probable_error"].update(half_the_step=error(0.012), blocks_strike=True)
    assert errors.rows_of(Finished)[1][-1] == "as much; blocks strike each other, runs in other steps may go another way"
    Finished.summary["probable_error"].update(blocks_strike=False, blocks_may_flutter=True)
    assert errors.rows_of(Finished)[1][-1] == "as much; at least, as blocks with little damping slide, and may flutter in yet shorter steps"
    Finished.summary["probable_error"].update(watched="8 blocks", acceleration_peaks_at_an_end="crest")
    assert errors.rows_of(Finished)[0][-1].startswith("a run in steps of 0.002 s, at 8 blocks")
    assert errors.rows_of(Finished)[1][-1].endswith("the acceleration of crest is largest at an end of the record, where nothing is filtered nor told")
    Finished.summary["mesh_error"] = {"estimated": True, "coarser_meshes": 1, "order_is_seen": False, "mesh": error(0.02), "half_the_size": error(0.01)}
    assert errors.rows_of(Finished)[-1][-1] == "roughly: no order is seen in these meshes"
    Finished.summary["mesh_error"]["order_is_seen"] = True
    assert errors.rows_of(Finished)[-1][-1] == ""
    Finished.summary["mesh_error"]["half_the_step_too"] = True
    assert errors.rows_of(Finished)[-1][0] == "with half of it and half the step"
    Finished.summary["mesh_error"]["smaller_cells_at_corners"] = True
    assert errors.rows_of(Finished)[-2][-1].endswith("a mesh twice as coarse, smaller cells at inward corners")
