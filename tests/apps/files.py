"""A folder of its own for each test of a command."""
import os
import pathlib
import tempfile
import unittest

# What earlier runs kept in the user's folder shall change no test.
os.environ.setdefault("THENAR_CACHE", "off")


class Files(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)

    def path(self, name, text=None):
        """The path of a file there, written if a text is given."""
        path = pathlib.Path(self.folder.name) / name
        if text is not None:
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(text)
        return str(path)
