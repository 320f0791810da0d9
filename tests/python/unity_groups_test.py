"""cmake/unity_groups.py: which sources are compiled as one piece."""

import pathlib
import subprocess
import tempfile
import unittest

source = pathlib.Path(__file__).resolve().parents[2]
OPEN, CLOSE = "namespace furrow {\nnamespace {\n\n", "\n}  // namespace\n}  // namespace furrow\n"


class UnityGroups(unittest.TestCase):

    def groups(self, **texts):
        """Names of the sources that share a piece, piece by piece."""
        with tempfile.TemporaryDirectory() as kept:
            root = pathlib.Path(kept)
            for name, text in texts.items():
                (root / f"{name}.{'h' if name.endswith('_header') else 'cpp'}").write_text(text)
            lines = "".join(f"program\t{root / name}.cpp\n" for name in texts if not name.endswith("_header"))
            done = subprocess.run([source / "cmake/unity_groups.py", root], input=lines, capture_output=True, text=True, check=True)
            pieces = [line for line in done.stdout.splitlines() if "UNITY_GROUP" in line]
            return [[name for name in texts if f"/{name}.cpp" in piece] for piece in pieces]

    def together(self, one, other, header="int nothing();\n"):
        return self.groups(one=one, other=other, a_header=header) == [["one", "other"]]

    def test_sources_without_a_name_in_common_share_a_piece(self):
        self.assertTrue(self.together(OPEN + "int first() { return 1; }" + CLOSE, OPEN + "int second() { return 2; }" + CLOSE))

    def test_a_private_name_of_both_keeps_them_alone(self):
        for declaration in ("int same() { return 1; }", "struct same {", "constexpr double same = 1;", "using same = int;",
                            "template <class T>\nT same(T value) {", "std::map<int, double>\nsame(int first,", "bool same[4];"):
            self.assertFalse(self.together(OPEN + declaration + CLOSE, OPEN + "double same(double x) {" + CLOSE), declaration)

    def test_the_same_alias_of_both_is_none(self):
        alias = OPEN + "namespace fs = std::filesystem;\nusing nlohmann::json;" + CLOSE
        self.assertTrue(self.together(alias, alias))

    def test_a_private_name_may_not_be_one_of_the_others_headers(self):
        other = '#include "a_header.h"\n' + OPEN + "int second() { return 2; }" + CLOSE
        self.assertFalse(self.together(OPEN + "int same() { return 1; }" + CLOSE, other, "namespace furrow {\nint same();\n"))

    def test_a_private_variable_may_not_be_shadowed_a_function_may(self):
        other = OPEN + "int second(int same) { return same; }" + CLOSE
        self.assertFalse(self.together(OPEN + "constexpr int same = 1;" + CLOSE, other))
        self.assertTrue(self.together(OPEN + "int same() { return 1; }" + CLOSE, other))

    def test_a_variable_of_a_header_may_not_be_shadowed_by_a_source_that_does_not_have_it(self):
        one, other = '#include "a_header.h"\n' + OPEN + "int first() { return 1; }" + CLOSE, OPEN + "int second(int same) { return same; }" + CLOSE
        self.assertFalse(self.together(one, other, "namespace furrow {\ninline constexpr Pair full{}, same{9, 1.4};\n}  // namespace furrow\n"))
        self.assertTrue(self.together(one, other, "namespace furrow {\ninline constexpr Pair full{}, another{9, 1.4};\n}  // namespace furrow\n"))

    def test_text_within_a_raw_string_declares_nothing(self):
        text = 'constexpr auto %s = R"(\nsame = 1\n)";'
        self.assertTrue(self.together(OPEN + text % "first" + CLOSE, OPEN + text % "second" + CLOSE))

    def test_using_directives_and_macros_keep_a_source_alone(self):
        plain = OPEN + "int second() { return 2; }" + CLOSE
        self.assertFalse(self.together("namespace furrow {\nusing namespace test;\n}  // namespace furrow\n", plain))
        self.assertFalse(self.together("// One\n#define MACRO 1\n", plain))

    def test_a_piece_has_at_most_eight_sources(self):
        pieces = self.groups(**{f"s{n}": OPEN + f"int f{n}() {{ return 1; }}" + CLOSE for n in range(20)})
        self.assertEqual([len(piece) for piece in pieces], [8, 8, 4])


if __name__ == "__main__":
    unittest.main()
