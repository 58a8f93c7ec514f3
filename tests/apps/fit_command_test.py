"""`thenar fit` against a planar finger, its forces, its cost and its minimum written here anew.

Usage: fit_command_test.py PROGRAM. Needs numpy and h5py.
"""
import json
import math
import pathlib
import subprocess
import sys
import unittest

import h5py
import numpy as np

import commands_test as finger
from files import Files
from patience import HANG

PROGRAM = sys.argv.pop(1)
POSTURES = [(20, 30, 20), (45, 60, 35), (10, 80, 50), (60, 20, 40)]  # [deg]
LOADS = ["FDP", "FDS"]
TENSION = 8.0  # [N]
NOISE = 0.05  # [N]

# What is free: prior mean and sd, as the settings below say them.
PARAMETERS = {"gain/FDP": (1, 0.2), "gain/FDS": (1, 0.2), "path/FDP/2/dorsal": (0, 1.5),
              "path/FDS/2/dorsal": (0, 1.5), "angle/PIP3": (0, 4), "angle/DIP3": (0, 4)}
UNITS = {"gain": "", "path": "_mm", "angle": "_deg"}
TRUTH = [1.15, 0.9, 1.0, -1.2, 3.0, -4.0]


def settings():
    rows = ["source = 'Synek2019'"]
    for name, (_, sd) in PARAMETERS.items():
        unit = UNITS[name.split("/")[0]]
        rows += ["[[parameter]]", f"match = '{name}'", "state = 'free'", f"sd{unit} = {sd}",
                 f"between_sd{unit} = 0"]
    return "\n".join(rows) + "\n"


def force(values, posture, load):
    """Proximal and dorsal force of the pinned tip [N]."""
    at = dict(zip(PARAMETERS, values))
    angles = [posture[0], posture[1] + at["angle/PIP3"], posture[2] + at["angle/DIP3"]]
    points = finger.strand_points(load)
    segment, (x, y, z) = points[1]
    points[1] = (segment, (x, y + at[f"path/{load}/2/dorsal"], z))
    arms = finger.moment_arms(points, angles)
    torque = [at[f"gain/{load}"] * TENSION * arm for arm in arms]
    planar = finger.PlanarFinger(angles)
    fx, fy = finger.least_squares(planar.jacobian(), torque)
    c, s = math.cos(planar.bend["DP3"]), math.sin(planar.bend["DP3"])
    return np.array([c * fx + s * fy, c * fy - s * fx])


def trials():
    return [(posture, load) for posture in POSTURES for load in LOADS]


class PlanarFit(Files):
    def setUp(self):
        super().setUp()
        rng = np.random.default_rng(3)
        self.measured = [force(TRUTH, *trial) + NOISE * rng.standard_normal(2)
                         for trial in trials()]

    def residuals(self, values):
        """Of data and priors; the radial forces weigh nothing."""
        data = [(force(values, *trial) - f) / NOISE for trial, f in zip(trials(), self.measured)]
        prior = [(v - mean) / sd for v, (mean, sd) in zip(values, PARAMETERS.values())]
        return np.concatenate([*data, prior])

    def cost(self, values):
        return 0.5 * float(self.residuals(values) @ self.residuals(values))

    def slopes(self, values):
        """Jacobian of the residuals by prior sds, by central differences."""
        columns = []
        for i, (_, sd) in enumerate(PARAMETERS.values()):
            step = np.zeros(len(values))
            step[i] = 1e-3 * sd
            columns.append((self.residuals(values + step) - self.residuals(values - step)) / 2e-3)
        return np.array(columns).T

    def minimum(self):
        """By Gauss-Newton steps, halved until they help."""
        values = np.array([mean for mean, _ in PARAMETERS.values()], float)
        sds = np.array([sd for _, sd in PARAMETERS.values()])
        for _ in range(30):
            J, r = self.slopes(values), self.residuals(values)
            step = -np.linalg.solve(J.T @ J, J.T @ r) * sds
            while self.cost(values + step) > self.cost(values) and np.abs(step / sds).max() > 1e-9:
                step /= 2
            values = values + step
            if np.abs(step / sds).max() < 1e-7:
                return values
        self.fail("the reference did not converge")

    def experiment(self):
        text = ['name = "planar"', 'digit = "middle"', 'source = "Synek2019"', "[protocol]",
                'hold = "pinned"', "[force]", 'segment = "DP3"',
                'components = ["proximal", "dorsal", "radial"]']
        for i, (mcp, pip, dip) in enumerate(POSTURES):
            text += ["[[posture]]", f'name = "p{i}"',
                     f"angles_deg = {{MCP3_FE = {mcp}, PIP3 = {pip}, DIP3 = {dip}}}"]
        text += ["[trials]", "rows = ["]
        for (posture, load), (proximal, dorsal) in zip(trials(), self.measured):
            text.append(f'{{posture = "p{POSTURES.index(posture)}", tension_N = '
                        f"{{{load} = {TENSION}}}, force_N = [{proximal!r}, {dorsal!r}, 0], "
                        f"sd_N = [{NOISE}, {NOISE}, 1e6]}},")
        return self.path("planar.toml", "\n".join([*text, "]\n"]).replace("np.float64", ""))

    def fitted(self, *more):
        output = self.path("fit.h5")
        result = subprocess.run(
            [PROGRAM, "fit", self.experiment(), "--subject", finger.MIDDLE, "--settings",
             self.path("few.toml", settings()), "-o", output, "--json", *more],
            capture_output=True, text=True, check=False, timeout=HANG)
        self.assertEqual(result.returncode, 0, result.stderr)
        with h5py.File(output) as file:
            names = [name.decode() for name in file["parameters/name"]]
            values = file["parameters/specimens/planar/value"][:]
            sds = file["parameters/specimens/planar/sd"][:]
        rows = [names.index(name) for name in PARAMETERS]
        return json.loads(result.stdout), values[rows], sds[rows]

    def test_the_minimum_is_that_of_the_formulas(self):
        expected = self.minimum()
        sds = np.array([sd for _, sd in PARAMETERS.values()])
        J = self.slopes(expected)
        after = np.sqrt(np.diag(np.linalg.inv(J.T @ J)))  # in prior sds
        for method in ("ceres", "ipopt"):
            summary, values, told = self.fitted("--method", method)
            self.assertEqual(summary["status"], "converged")
            self.assertAlmostEqual(summary["cost"], self.cost(expected),
                                   delta=1e-5 * self.cost(expected))
            # Within a hundredth of what is not known of each.
            np.testing.assert_array_less(np.abs(values - expected) / (sds * after), 0.01)
            np.testing.assert_allclose(told, sds * after, rtol=1e-3)

    def test_no_component_of_the_gradient_is_left(self):
        _, values, _ = self.fitted()
        J, r = self.slopes(values), self.residuals(values)
        curvature = np.sum(J * J, axis=0)
        left = np.abs(J.T @ r) / np.sqrt(curvature)  # way to each one's own minimum, in its sds
        np.testing.assert_array_less(left, 0.01)


if __name__ == "__main__":
    unittest.main()
