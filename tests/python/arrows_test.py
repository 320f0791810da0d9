"""scripts/arrows: which includes between rooms it lets pass, on made-up trees."""

import pathlib
import shutil
import subprocess
import tempfile
import unittest

source = pathlib.Path(__file__).resolve().parents[2]


class Arrows(unittest.TestCase):

    def judged(self, files):
        """Exit code and complaints on a tree of these files, path by text."""
        with tempfile.TemporaryDirectory() as kept:
            top = pathlib.Path(kept)
            for name, text in {"src/system/parts.h": '#include "physics/disc.h"\n', **files}.items():
                (top / name).parent.mkdir(parents=True, exist_ok=True)
                (top / name).write_text(text)
            (top / "scripts").mkdir()
            shutil.copy(source / "scripts/arrows", top / "scripts/arrows")
            done = subprocess.run([top / "scripts/arrows"], capture_output=True, text=True)
            return done.returncode, done.stderr

    def good(self, name, text):
        self.assertEqual(self.judged({name: text}), (0, ""), text)

    def bad(self, name, text, complaint):
        code, complaints = self.judged({name: text})
        self.assertEqual(code, 1, text)
        self.assertIn(f"{name}: {complaint}", complaints)

    def test_includes_of_rooms_below_and_of_the_system_pass(self):
        for line in ('#include "physics/vec2.h"', "#include <vector>", "#include <sys/stat.h>", "#  include <Eigen/Dense>  // solver",
                     '// #include "kernel/lanes.h"', '#include "system/place.h"'):
            self.good("src/system/layout.h", line + "\n")

    def test_arrows_that_go_up_or_sideways_fail(self):
        self.bad("src/physics/link.h", '#include "kernel/lanes.h"\n', "physics includes kernel, which is not below it")
        self.bad("src/physics/link.h", '#include <cmath>\n\n  #  include\t"kernel/lanes.h"  // fast\n', "physics includes kernel")
        self.bad("src/reference/flow.cpp", '#include "kernel/lanes.h"\n', "reference includes kernel")
        self.bad("src/physics/link.hpp", '#include "kernel/lanes.h"\n', "physics includes kernel")
        self.bad("src/physics/link.h", '#include "kernel/Lanes-4.hpp"\n', "physics includes kernel")
        self.bad("verification/spring.h", '#include "validation/commands.h"\n', "verification includes validation")

    def test_no_form_of_an_include_passes_by_the_rooms(self):
        self.bad("src/physics/link.h", "#include <kernel/lanes.h>\n", "<kernel/lanes.h> is of this project")
        self.bad("src/physics/link.h", "#include <src/kernel/lanes.h>\n", "<src/kernel/lanes.h> is of this project")
        self.bad("src/physics/link.h", '#include "../kernel/lanes.h"\n', '"../kernel/lanes.h" does not name its room')
        self.bad("src/physics/link.h", '#include "physics/../kernel/lanes.h"\n', '"physics/../kernel/lanes.h" does not name its room')
        self.bad("src/physics/link.h", '#include "src/kernel/lanes.h"\n', '"src/kernel/lanes.h" does not name its room')
        self.bad("src/physics/link.h", '#include "vec2.h"\n', '"vec2.h" does not name its room')
        self.bad("src/physics/link.h", "#include LANES\n", "the include of LANES names no file")

    def test_what_stands_in_no_room_fails(self):
        self.bad("src/tools/x.h", "\n", "tools is no room")
        self.bad("src/x.h", "\n", "x.h is no room")
        self.bad("src/physics/link.h", '#include "tools/x.h"\n', '"tools/x.h": tools is no room')

    def test_no_room_includes_tests(self):
        self.bad("src/program/run.cpp", '#include "tests/unit/scenes.h"\n', '"tests/unit/scenes.h": tests is no room, or one above all')
        self.bad("validation/x.cpp", "#include <tests/unit/scenes.h>\n", "<tests/unit/scenes.h> is of this project")


if __name__ == "__main__":
    unittest.main()
