"""Every place that makes a path of a text, or opens a file, where texts come from outside: counted, with its reason.

Run from the repository root. A new place is an offence until it goes through base/outside_path.h or base/inside_folder.h
(or opens what nobody outside has named), and its count is raised here with the reason.
"""
import pathlib
import re
import sys

# What opens, writes, removes or runs something.
OPENS = re.compile(r"\b[io]?fstream\b|\bfopen\(|\bopen(at)?\(\w+\.c_str|\bwrite_files?\(|\brequire_writable\(|\bcreate_director\w+\(|"
                   r"\bread_(file|source|text_file|start|guarded)\(|\bfs::(copy|rename|remove|remove_all|create_\w+)\(|\bmkdtemp\(|"
                   r"\btmpfile\(|\b(std::)?(remove|rename)\(\w+\.c_str|\bunlink(at)?\(|\bexec[vl]\w*\(|\bposix_spawnp?\(|\bpopen\(|"
                   r"\bsystem\(|\bchdir\(|\bdlopen\(")
# What joins a folder and a name.
JOINS = re.compile(r"(path\([^()]*(\(\))?[^()]*\)|[Ff]older\w*(\(\))?|parent_path\(\)|place|root)\)? / \(?[\w.\"(]")

# file -> (number of places, why they may be)
OPENED = {
    "server/session_log.cpp": (4, "a log that the command line names, checked by outside_path(); an unnamed temporary file"),
    "server/token_file.cpp": (6, "the token: a name made of the port, in a folder of the user's own"),
    "live/world/live_world.cpp": (2, "the session's own folder"),
    "live/world/world_files.cpp": (1, "require_writable() of InsideFolder"),
    "live/world/world_import.cpp": (2, "a numbered folder in the session's own"),
    "report/page.cpp": (1, "a page that the command line names"),
    "apps/demo.cpp": (1, "the folder of -o"),
    "apps/fit.cpp": (1, "an output that the command line names"),
    "apps/grasp.cpp": (1, "an output that the command line names"),
    "apps/quality.cpp": (1, "an output that the command line names"),
    "apps/outputs.cpp": (3, "outputs that the command line names"),
    "apps/pads/pad.cpp": (1, "an output that the command line names"),
    "apps/rerun.cpp": (2, "thenar itself, in the folder of the run: what the user asks for by name"),
    "apps/live/view.cpp": (1, "the browser, with an address that thenar made"),
}
CHECKED_AT_READING = "it went through linked_file() when its file was read"
JOINED = {
    "api/named/data_folders.cpp": (5, "names are looked for by find_in(), which calls outside_fault(); folders of ours"),
    "api/named/hands.cpp": (1, "a name for find_in()"),
    "api/named/portable_world.cpp": (8, "numbers of ours; files that went through linked_file(), written through InsideFolder"),
    "api/named/recorded_run.cpp": (1, "an input of a recorded run: its digest is compared, nothing else"),
    "api/named/shipped_data.cpp": (1, "a folder of ours"),
    "api/named/worlds.cpp": (1, "a hand's file, " + CHECKED_AT_READING),
    "api/pads/fit_pad.cpp": (1, "a mesh to be named in a new file, " + CHECKED_AT_READING),
    "api/pads/press_rungs.cpp": (1, "outside_fault() stands below it"),
    "api/scenes/read_scene_run.cpp": (2, "folders of ours; a recorded path that went through outside_path()"),
    "api/scenes/open_scene.cpp": (1, "a hand's file, " + CHECKED_AT_READING),
    "live/world/imported_files.cpp": (2, "a hand's file below the session's own folder; a number; both written through InsideFolder"),
    "live/world/live_hand.cpp": (1, "a key of the cache, " + CHECKED_AT_READING),
    "live/world/live_world.cpp": (1, "the session's own folder"),
    "live/world/world_files.cpp": (1, "a name that went through outside_path()"),
    "live/world/world_import.cpp": (2, "a number; a name that went through outside_path()"),
    "data/io/graspit/graspit_link.cpp": (1, "a mesh that find_mesh() looks at before it is read"),
    "data/io/mesh/foreign_mesh.cpp": (4, "the program that reads meshes, by a name of ours"),
    "data/io/mesh/shape_toml.cpp": (1, CHECKED_AT_READING),
    "data/io/mesh/stl_copy.cpp": (2, "a name made of letters, digits, '.', '-' and '_'; " + CHECKED_AT_READING + ", and is compared, not opened"),
    "data/io/robot/graspit_robot.cpp": (1, "outside_fault() and may_link() stand around it"),
    "data/io/robot/import_mesh.cpp": (1, "find_mesh(): outside_fault() and may_link() stand around it"),
    "data/io/robot/mjcf_geom.cpp": (1, "a mesh that find_mesh() looks at before it is read"),
    "data/io/robot/mjcf_source.cpp": (1, "outside_fault() and is_in_folder_of() stand around it"),
    "data/io/robot/urdf_export.cpp": (1, "a name made of letters, digits, '.', '-' and '_'"),
    "data/io/scene/scene.cpp": (1, CHECKED_AT_READING),
    "data/io/world/graspit_world.cpp": (1, "outside_fault() and may_link() stand around it"),
    "data/io/world/world.cpp": (1, CHECKED_AT_READING),
    "data/io/world/world_keys.cpp": (3, "outside_fault() stands above a name of the catalogue; " + CHECKED_AT_READING),
}
FOLDERS = ["server", "live", "report", "apps"]                     # texts of clients, logs, drops
LINKS = ["server", "api", "report", "apps", "data/io", "dynamics/scene"]  # names that files hold, too


def lines_with(pattern, path):
    found = []
    for number, line in enumerate(path.read_text().splitlines(), 1):
        code = line.split("//")[0]
        if pattern.search(code) and not code.startswith("#include"):
            found.append(f"{path}:{number}: {line.strip()}")
    return found


def offences(pattern, folders, known):
    out = []
    for folder in folders:
        for path in sorted(pathlib.Path(folder).rglob("*")):
            if path.suffix not in (".h", ".cpp"):
                continue
            found = lines_with(pattern, path)
            wanted = known.get(str(path), (0, ""))[0]
            if len(found) != wanted:
                out += [f"{path}: {len(found)} places, {wanted} are known in tests/outside_paths_test.py", *found]
    return out


bad = offences(OPENS, FOLDERS, OPENED) + offences(JOINS, LINKS, JOINED)
print("\n".join(bad))
sys.exit(bool(bad))
