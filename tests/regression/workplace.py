"""A folder where the commands of the documents work as they are written: ./qs, examples/, results/."""
import os
import subprocess
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent.parent
PROGRAM = ROOT / "build/release/bin/quicksand"


class Workplace:
    """The folder while it lasts; ./qs in it is the program."""

    def __init__(self, program):
        self.folder = tempfile.TemporaryDirectory(prefix="quicksand_regression_")
        self.path = Path(self.folder.name)
        (self.path / "examples").symlink_to(ROOT / "examples")
        script = self.path / "qs"
        script.write_text(f"#!/bin/sh\nexec '{program}' \"$@\"\n")
        script.chmod(0o755)

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.folder.cleanup()

    def run(self, command):
        """Exit code and what was printed."""
        environment = {"OMP_NUM_THREADS": "1", **os.environ}
        done = subprocess.run(["bash", "-c", command], cwd=self.path, env=environment, text=True,
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT, check=False)
        return done.returncode, done.stdout
