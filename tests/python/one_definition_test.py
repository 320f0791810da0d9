"""scripts/one_definition sees a type in whatever form it is defined, and nothing that defines none."""

import importlib.machinery
import importlib.util
import pathlib
import subprocess
import sys
import tempfile
import unittest

script = pathlib.Path(__file__).resolve().parents[2] / "scripts/one_definition"
sys.dont_write_bytecode = True  # beside the script
loader = importlib.machinery.SourceFileLoader("one_definition", str(script))
one_definition = importlib.util.module_from_spec(importlib.util.spec_from_loader("one_definition", loader))
loader.exec_module(one_definition)


def names_in(text):
    return [name for name, _ in one_definition.types_in(text)]


# How the type a::Point may be defined, from inside of namespace a.
FORMS = r"""
struct Point {};
class Point {};
union Point { int i; };
struct [[nodiscard]] Point {};
struct [[nodiscard("a { b")]] [[deprecated]] Point {};
struct alignas(16) Point {};
struct alignas(sizeof(double[2])) [[nodiscard]] Point {};
struct __attribute__((packed)) Point {};
struct Point final {};
struct Point final : Base {};
class Point : public Base {};
class Point\n    : public Base,\n      private Other<Base, (1 > 0)> {\n};
struct Point : Base<int>::Of {};
struct MACRO Point {};
struct /* why { */ Point // so {\n{};
template <class T> struct Point {};
template <class T, class = std::enable_if_t<(sizeof(T) < 8)>>\nclass Point {};
template <class T>\n  requires std::integral<T>\nstruct Point {};
enum Point { one };
enum class Point { one };
enum struct Point : std::uint8_t { one };
enum class [[nodiscard]] Point : unsigned long { one };
enum Point : int { one };
typedef struct { int i; } Point;
typedef struct Point { int i; } Point;
struct Point { struct Inner { int i; }; } point;
inline void before() { struct Local {}; } struct Point {};
const char text[] = "}"; char sign = '}'; int many = 1'000; struct Point {};
const char raw[] = R"x(} )" " }})x"; struct Point {};
#define OPENS {\nstruct Point {};
int list[] = {1, 2}; int of = list[list[0]]; struct Point {};
""".strip().split("\n")

NONE = """
struct Point;
class Point; enum class Point : int;
struct Point* first();
struct Point made() { return {}; }
using Point = Other;
template <class T> struct Point;
extern struct Point point;
void within() { struct Point {}; }
struct Outer { struct Point {}; };
namespace { struct Point {}; }
// struct Point {};
/* struct Point {}; */
const char text[] = "struct Point {};";
#define POINT struct Point {};
friend struct Point;
template <struct Point* p> void f() {}
""".strip().split("\n")


class OneDefinition(unittest.TestCase):

    def test_a_type_of_any_form_is_seen(self):
        for form in FORMS:
            with self.subTest(form):
                text = "namespace a {\n" + form.replace("\\n", "\n") + "\n}  // namespace a\nstruct After {};\n"
                self.assertEqual(names_in(text), ["a::Point", "After"])

    def test_what_defines_no_type_of_the_namespace_is_not(self):
        for form in NONE:
            with self.subTest(form):
                self.assertEqual([n for n in names_in(f"namespace a {{\n{form}\n}}\nstruct After {{}};") if "Point" in n], [])
                self.assertIn("After", names_in(f"namespace a {{\n{form}\n}}\nstruct After {{}};"))

    def test_namespaces_of_any_form_are_known(self):
        for space in ("namespace a::b {{ {} }}", "namespace a {{ inline namespace b {{ {} }} }}", "namespace a {{ namespace b {{\n{}\n}}\n}}",
                      "namespace a {{ namespace [[deprecated]] b {{ {} }} }}", "namespace a::inline b {{ {} }}",
                      "namespace x = a; namespace a::b {{ extern \"C\" {{ {} }} }}", "namespace a {{ namespace b\n{{\n{}\n}} }}"):
            with self.subTest(space):
                self.assertEqual(names_in(space.format("struct Point {};")), ["a::b::Point"])

    def test_specialisations_are_types_of_their_own(self):
        self.assertEqual(names_in("template <class T> struct A {}; template <> struct A<int> {};"), ["A", "A<int>"])

    def test_two_of_one_name_are_named_with_the_lines_of_the_name(self):
        with tempfile.TemporaryDirectory() as kept:
            root = pathlib.Path(kept)
            (root / "src").mkdir()
            (root / "src/one.h").write_text("/* a\n*/\nstruct [[nodiscard]]\nPoint\n{\n};")
            (root / "src/other.h").write_text("struct Point final {};")
            done = subprocess.run([script, root], capture_output=True, text=True, check=False)
            self.assertIn("Point: src/one.h:4, src/other.h:1", done.stdout)
            self.assertEqual(done.returncode, 1)


if __name__ == "__main__":
    unittest.main()
