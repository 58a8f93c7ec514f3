"""Checks includes: folders include from folders below, rooms in no circle, third parties in their fences.
Packages are found in one file; thenar/thenar.h reaches every question of api/, clang-tidy reads every room, and libraries name
no option of the command.

Run from the repository root. Prints every offence as path:line and fails if there is one.
"""
import pathlib
import re
import sys

# A folder may include only its own files and those of the folders named here: folders below it in the
# order of rooms (docs/architecture.md).
MAY_SEE = {
    "base": [],
    "solvers": ["base"],
    "solvers/sparse": ["base"],
    "contact": ["base", "solvers"],
    "geometry": ["base"],
    "geometry/collision": ["base", "geometry"],
    "geometry/manifold": ["base", "geometry", "geometry/collision"],
    "sampling/methods": ["base"],
    "sampling/run": ["base", "sampling/methods"],
    "sampling/diagnostics": ["base", "sampling/methods", "sampling/run"],
    "data/io": ["base"],
    "data/io/mesh": ["base", "geometry", "data/io"],
    "data/io/pad": ["base", "solvers", "geometry", "geometry/collision", "data/io", "data/io/mesh", "pad_laws"],
    "data/io/graspit": ["base", "data/io"],
    "data/io/foreign_mesh": ["base", "data/io", "data/io/mesh", "data/io/graspit"],
    "data/io/robot": ["base", "solvers", "geometry", "data/io", "data/io/mesh", "data/io/graspit"],
    "data/io/world": ["base", "geometry", "data/io", "data/io/mesh", "data/io/graspit", "data/io/robot", "data/io/pad", "pad_laws"],
    "data/io/scene": ["base", "geometry", "data/io", "data/io/mesh", "data/io/pad", "data/io/world", "pad_laws"],
    "hand": ["base", "geometry", "data/io", "data/io/robot/drive_coupling.h"],
    "hand/skin": ["base", "geometry", "data/io", "hand"],
    "pad_laws": ["base", "solvers", "geometry", "geometry/collision"],
    "pads": ["base", "solvers", "solvers/sparse", "contact", "geometry", "geometry/collision", "pad_laws",
             "data/io/pad"],
    "pads/motion": ["base", "solvers", "solvers/sparse", "geometry", "geometry/collision", "pad_laws", "pads"],
    "tendons/wrapping": ["base", "data/io", "hand"],
    "tendons": ["base", "solvers", "data/io", "hand", "tendons/wrapping"],
}
TENDONS = ["base", "solvers", "geometry", "data/io", "hand", "tendons/wrapping", "tendons"]
MAY_SEE |= {
    "tendons/forces": TENDONS,
    "tendons/net": TENDONS + ["tendons/forces"],
    "tendons/muscle": TENDONS,
    "tendons/topology": TENDONS + ["tendons/forces", "tendons/net"],
    "hand_versions": TENDONS + ["tendons/forces", "tendons/net", "hand/skin"],
}
FITS = TENDONS + ["tendons/forces", "tendons/net", "tendons/topology"]
MAY_SEE |= {
    "kinematics_fit/model": FITS,
    "kinematics_fit/kernel": FITS + ["kinematics_fit/model"],
}
FITS += ["kinematics_fit/model", "kinematics_fit/kernel"]
MAY_SEE |= {
    "kinematics_fit": FITS,
    "kinematics_fit/bands": FITS + ["kinematics_fit"],
    "posterior": FITS + ["sampling/methods", "kinematics_fit"],
}
POSTERIOR = FITS + ["sampling/methods", "sampling/run", "sampling/diagnostics", "kinematics_fit", "posterior"]
MAY_SEE |= {
    "posterior/run": POSTERIOR,
}
# The interface of a hand, and nothing else of hand/.
GRASP = ["base", "solvers", "geometry", "geometry/collision", "pad_laws", "data/io", "data/io/world",
         "hand/hand.h", "hand/multibody.h"]
MAY_SEE |= {
    "grasp/contact": GRASP,
    "grasp/limits": GRASP + ["grasp/contact"],
    "grasp/quality": GRASP + ["grasp/contact", "grasp/limits"],
    "grasp/closing": GRASP + ["grasp/contact", "grasp/limits", "grasp/quality"],
    "grasp/robot": GRASP + ["data/io/robot", "grasp/contact", "grasp/limits", "grasp/closing"],
    "grasp/compare": GRASP + ["grasp/contact", "grasp/limits", "grasp/quality", "grasp/closing"],
}
MAY_SEE |= {
    "dynamics/mechanism": ["base", "geometry", "data/io", "data/io/robot", "data/io/world", "data/io/scene/joint_kind.h",
                           "hand"],
}
MECHANISMS = MAY_SEE["dynamics/mechanism"] + ["dynamics/mechanism"]
MAY_SEE |= {
    "dynamics/stepping": MECHANISMS + ["solvers", "geometry/collision", "geometry/manifold", "contact"],
}
MAY_SEE["dynamics/ligament"] = MAY_SEE["dynamics/stepping"] + ["dynamics/stepping"]
MAY_SEE["dynamics/compliant"] = MAY_SEE["dynamics/stepping"] + ["dynamics/stepping"]
HUMANS = ["hand/skin", "tendons", "tendons/net", "tendons/muscle", "hand_versions"]
MAY_SEE["dynamics/human"] = MAY_SEE["dynamics/stepping"] + ["dynamics/stepping"] + HUMANS
PADS = ["solvers/sparse", "pad_laws", "pads", "pads/motion", "data/io/pad"]
MAY_SEE["dynamics/pads"] = MAY_SEE["dynamics/stepping"] + ["dynamics/stepping"] + PADS
MAY_SEE["dynamics/scene"] = MAY_SEE["dynamics/human"] + PADS + [
    "data/io/scene", "dynamics/ligament", "dynamics/human", "dynamics/pads"]
LIBRARIES = list(MAY_SEE)
API = ["api", "api/named", "api/pads", "api/scenes"]
LIVE = ["live", "live/world"]
STUDIES = ["studies/thumb", "studies/questions", "studies/pages", "studies/demo"]
MAY_SEE["thenar"] = LIBRARIES + API + LIVE  # the header of all public headers
# The questions that a person asks, and their answers as words, tables, JSON and pages.
REPORT = LIBRARIES + API + ["report"]
PAGES = REPORT + ["report/picture", "report/draws", "report/answers"]
MAY_SEE |= {
    "api/named": LIBRARIES,
    "api/pads": LIBRARIES + ["api/named"],
    "api/scenes": LIBRARIES + ["api/named"],
    "api": LIBRARIES + ["api/named", "api/pads", "api/scenes"],
    "live": LIBRARIES + API,
    "live/world": LIBRARIES + API + ["live"],
    "report": LIBRARIES + API,
    "report/picture": REPORT,
    "report/draws": REPORT,
    "report/answers": REPORT,
    "report/explain": REPORT,
    "report/pads": PAGES,
    "report/pages": PAGES,
    "studies/thumb": POSTERIOR + ["posterior/run"],
    "studies/questions": LIBRARIES + API + ["studies/thumb"],
    "studies/pages": PAGES + ["report/pages", "studies/thumb", "studies/questions"],
    "studies/demo": PAGES + ["report/pages", "report/pads", "studies/thumb", "studies/questions", "studies/pages"],
    "questions": PAGES + ["report/pages", "report/pads"],
    "server": PAGES + LIVE + ["report/pages", "report/pads", "questions"],
    "server/methods": PAGES + LIVE + ["report/pages", "report/pads", "report/explain", "questions", "server"],
    "apps": PAGES + LIVE + ["report/explain", "report/pads", "report/pages", "questions", "server", "server/methods"] + STUDIES,
    "bench": PAGES + LIVE + ["report/pages", "server", "server/methods", "tests"],  # charts; the sample scenes
    "tests": PAGES + LIVE + ["report/explain", "report/pads", "report/pages", "questions", "server", "server/methods",
                             "thenar"] + STUDIES,
}
WITH_SUBFOLDERS = ["sampling/run", "apps", "bench", "tests"]  # folders that count with their subfolders as one

# Third parties, and the only files that may include them. A folder's name allows the folder.
FENCES = {
    r"thenar/thenar\.h": ["tests/install/", "examples/"],
    r"Simbody\.h|(SimTK|simbody|simmath).*": ["hand/multibody.cpp", "dynamics/mechanism/simbody_mechanism.cpp",
                                                "dynamics/mechanism/simbody_machine.cpp",
                                                "dynamics/compliant/simbody_scene.cpp", "bench/", "tests/hand/"],
    r"ceres/jet\.h": ["kinematics_fit/force_jacobian.cpp", "bench/", "tests/"],
    r"ceres/.*": ["solvers/least_squares_ceres.cpp"],
    r"nlopt\..*": ["solvers/least_squares_nlopt.cpp"],
    r"(coin/)?Ip[A-Z].*\.hpp": ["solvers/nonlinear_program.cpp"],
    r"(coin/)?(Clp|Coin|Osi|Cbc).*": ["solvers/linear_program.cpp"],
    r"(cvode|nvector|sunmatrix|sunlinsol|sundials)/.*": ["solvers/stiff_ode.cpp",
                                                             "bench/"],
    r"kinsol/.*": ["bench/"],
    r"suitesparse/.*": ["solvers/sparse/sparse_cholesky.cpp"],
    r"libqhull.*": ["solvers/convex_hull.cpp", "bench/", "tests/grasp/", "tests/solvers/"],
    r"assimp/.*": ["data/io/foreign_mesh/assimp_mesh.cpp"],
    r"Inventor/.*": ["data/io/foreign_mesh/inventor_mesh.cpp"],
    r"(urdf_(parser|model)|console_bridge)/.*": ["data/io/robot/urdf.cpp"],
    r"pugixml\.hpp": ["data/io/graspit/", "data/io/robot/", "data/io/world/",
                      "data/io/foreign_mesh/collada_text.cpp", "tests/data/graspit/"],
    r"fcl/.*": ["tests/geometry/collision/fcl_distance.cpp", "bench/"],
    r"(hdf5|H5).*": ["data/io/result_file.cpp", "data/io/hdf5_guard.cpp", "tests/data/"],
    r"netcdf.*\.h": ["data/io/inference_file.cpp", "tests/data/"],
    r"mpi\.h": ["sampling/run/mpi/"],
    r"toml(\+\+|\.hpp).*": ["data/io/toml_node.cpp"],
    r"openssl/.*": ["base/provenance.cpp"],
    r"unsupported/Eigen/FFT": ["sampling/diagnostics/autocovariance.cpp"],
    r"unsupported/Eigen/SpecialFunctions": ["base/special_functions.cpp"],
    r"nlohmann/.*": ["report/", "questions/", "server/", "apps/", "data/io/json_node.cpp", "tests/", "bench/"],
    r"boost/.*": ["server/web_server.cpp", "server/line_server.cpp", "server/listener.h"],
    r"CLI/.*": ["apps/"],
    r"benchmark/.*": ["bench/"],
    r"mujoco/.*": ["bench/peers/"],
    r"ode/.*": ["bench/peers/peer_ode.cpp"],
    r"bt[A-Z].*": ["bench/peers/peer_bullet.cpp"],
    r"dart/.*": ["bench/peers/peer_dart.cpp"],
    r"deal\.II/.*": ["bench/peers/pad_dealii.cpp"],
    r"g(test|mock)/.*": ["tests/"],
    r"sanitizer/.*": ["tests/fuzz/"],
}
# Everywhere: Eigen, fmt, the standard library, POSIX, processor intrinsics.
ANYWHERE = (r"Eigen/.*|fmt/.*|[a-z_0-9]+"
            r"|(unistd|fcntl|dlfcn|malloc|poll|pthread|spawn|immintrin|cpuid)\.h"
            r"|sys/(file|random|resource|stat|prctl|wait)\.h")


def one_of(name, prefixes):
    return name.startswith(tuple(prefixes))


def folder_of(path):
    """The folder of a file: the longest folder of MAY_SEE that contains it."""
    folders = [str(folder) for folder in pathlib.PurePath(path).parents]
    return next((folder for folder in folders if folder in MAY_SEE), None)


def ours(path, folder, name):
    """Complaint about #include "name", if any."""
    included = folder_of(name)
    if name not in MAY_SEE[folder] and included != folder and included not in MAY_SEE[folder]:
        return f"{folder} may not include {name}"
    if not (pathlib.Path(name).is_file() or pathlib.Path(name + ".in").is_file()):
        return f"there is no {name}"
    return None


def theirs(path, folder, name):
    """Complaint about #include <name>, if any."""
    if re.fullmatch(ANYWHERE, name):
        return None
    for pattern, files in FENCES.items():
        if re.fullmatch(pattern, name):
            return None if one_of(str(path), files) else f"<{name}> belongs in {', '.join(files)}"
    return f"<{name}> has no fence in tests/floors_test.py"


def includes():
    """Complaints about the sources of all folders."""
    for top in sorted({folder.split("/")[0] for folder in MAY_SEE}):
        for path in sorted(pathlib.Path(top).rglob("*")):
            if path.suffix not in (".h", ".cpp") or "node_modules" in path.parts:
                continue
            folder = folder_of(path)
            if folder is None or (str(path.parent) != folder and folder not in WITH_SUBFOLDERS):
                yield f"{path}:1: the folder {path.parent} is not in MAY_SEE of tests/floors_test.py"
                continue
            for line, text in enumerate(path.read_text().splitlines(), 1):
                found = re.match(r'\s*#\s*include\s*(["<])([^">]+)', text)
                complaint = found and (ours if found[1] == '"' else theirs)(path, folder, found[2])
                if complaint:
                    yield f"{path}:{line}: {complaint}"


def packages():
    """Complaints about finding packages outside cmake/dependencies.cmake."""
    for path in [*pathlib.Path(".").glob("**/CMakeLists.txt"), *pathlib.Path("cmake").glob("*")]:
        if one_of(str(path), ["build/", "out/", "cmake/dependencies.cmake", "tests/install/"]):
            continue
        if "node_modules" in path.parts:
            continue
        for line, text in enumerate(path.read_text().splitlines(), 1):
            found = re.match(
                r"\s*(find_(?:package|library|path)|pkg_(?:check|search)_modules?)\b", text)
            if found:
                yield f"{path}:{line}: {found[1]} belongs in cmake/dependencies.cmake"


# Headers of api/ that programs do not ask: warnings, which results hold, and what the command says of files of any kind.
PRIVATE_API = {"api/contact_warnings.h", "api/tendon_warnings.h", "api/validate.h", "api/explain.h", "api/experiment_check.h"}


def public():
    """Complaints about questions of api/ that thenar/thenar.h does not reach."""
    todo, reached = ["thenar/thenar.h"], set()
    while todo:
        reached.add(header := todo.pop())
        text = pathlib.Path(header).read_text()
        todo += [name for name in re.findall(r'^#include "([^"]+)', text, re.M) if name not in reached]
    for path in sorted(path for folder in ("api", "api/pads", "api/scenes") for path in pathlib.Path(folder).glob("*.h")):
        if str(path) not in reached | PRIVATE_API:
            yield f"{path}:1: thenar/thenar.h does not reach it"


def circles():
    """Complaints about rooms, folders of the root, that may include each other, if only by way of others."""
    room = lambda name: name.split("/")[0]  # noqa: E731
    sees = {}
    for folder, others in MAY_SEE.items():
        sees.setdefault(room(folder), set()).update(room(other) for other in others if room(other) != room(folder))
    for start in sorted(sees):
        way, seen = [[start]], set()
        while way:
            path = way.pop()
            for other in sorted(sees[path[-1]]):
                if other == start:
                    yield f"tests/floors_test.py:1: a circle of rooms: {' > '.join([*path, start])}"
                    way = []
                    break
                if other not in seen:
                    seen.add(other)
                    way.append([*path, other])


def tidied():
    """Complaints about rooms whose headers clang-tidy does not read."""
    text = pathlib.Path(".clang-tidy").read_text()
    read = re.search(r"^HeaderFilterRegex: '/\(([^)]*)\)/", text, re.M)[1].split("|")
    for room in sorted({folder.split("/")[0] for folder in MAY_SEE}):
        if room not in read:
            yield f".clang-tidy:1: HeaderFilterRegex leaves out {room}/"
    for room in sorted(set(read) - {folder.split("/")[0] for folder in MAY_SEE}):
        yield f".clang-tidy:1: HeaderFilterRegex has {room}, which is no room of tests/floors_test.py"


# Rooms whose texts are read at a command line.
COMMAND_LINE = {"apps", "report", "studies", "server", "bench", "tests"}


def options():
    """Complaints about texts of libraries that name an option of the command: C++, Python and the socket have none."""
    for room in sorted({folder.split("/")[0] for folder in MAY_SEE} - COMMAND_LINE):
        for path in sorted(path for path in pathlib.Path(room).rglob("*") if path.suffix in (".h", ".cpp")):
            for line, text in enumerate(path.read_text().splitlines(), 1):
                if re.search(r'"[^"]*(?<![\w-])--(?:[a-z]|\{\})[^"]*"', text):
                    yield f"{path}:{line}: names an option: {text.strip()}"


bad = [*options(), *includes(), *packages(), *public(), *circles(), *tidied()]
print("\n".join(bad))
sys.exit(bool(bad))
