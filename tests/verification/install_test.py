#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""What cmake --install puts into a folder stands on its own: scenes run with their meshes, and their pictures are drawn
by the installed scripts.

Usage: install_test.py BUILD_DIR WORK_DIR
"""
import pathlib
import shutil
import subprocess
import sys

EXPECTED = ("bin/hybrid", "share/hybrid/tools/tool.py", "share/hybrid/parameters/majiagou/badong.prm",
            "share/hybrid/meshes/majiagou.geo", "share/hybrid/doc/user_guide.md", "share/hybrid/README.md")


def main():
    build, work = sys.argv[1], pathlib.Path(sys.argv[2])
    shutil.rmtree(work, ignore_errors=True)
    prefix, run = work / "prefix", work / "run"
    subprocess.run(["cmake", "--install", build, "--prefix", prefix], check=True, stdout=subprocess.DEVNULL)
    missing = [name for name in EXPECTED if not (prefix / name).is_file()]
    for name in missing:
        print(f"{name} was not installed")
    if missing:
        return 1
    (prefix / "share/hybrid/tools/hybrid_tools/style.py").open("a").write(f"\nopen({str(work / 'drawn')!r}, 'w').close()\n")
    hybrid = prefix / "bin/hybrid"
    subprocess.run([hybrid, prefix / "share/hybrid/parameters/verification/coupled_column.prm", "-s", "Time/End time=0.02",
                    "-s", f"Output/Directory={run}"], check=True, stdout=subprocess.DEVNULL, cwd=work)
    drawn = subprocess.run([hybrid, "plot", run], stdout=subprocess.PIPE, text=True, cwd=work)
    pictures = sorted(picture.name for picture in (run / "figures").glob("*.png"))
    print(drawn.stdout + " ".join(pictures))
    if not (work / "drawn").exists():
        print("the pictures were not drawn by the installed scripts")
        return 1
    return 0 if drawn.returncode == 0 and "overview.png" in pictures and "section.png" in pictures else 1


if __name__ == "__main__":
    sys.exit(main())
