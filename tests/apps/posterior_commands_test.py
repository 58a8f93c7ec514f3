"""End-to-end tests of `thenar fit --method mcmc` and `thenar posterior`.

Usage: posterior_commands_test.py PROGRAM [MPIEXEC]. Files are opened with xarray, and numbers are
computed here from the draws in them.
"""
import hashlib
import json
import math
import os
import pathlib
import random
import signal
import subprocess
import sys
import tempfile
import time
import unittest

import h5py
import numpy as np
import xarray as xr

from patience import stopped

ROOT = pathlib.Path(__file__).resolve().parents[2]
PROGRAM = sys.argv.pop(1)
MPIEXEC = sys.argv.pop(1) if len(sys.argv) > 1 and sys.argv[1][0] != "-" else None
SUBJECT = ROOT / "data/subjects/synek2019_middle.toml"
H01, H02, B01 = (ROOT / f"data/experiments/synek2019_{name}.toml" for name in ("H01", "H02", "B01"))
MEMORY = "/dev/shm" if pathlib.Path("/dev/shm").is_dir() else None  # syncs cost nothing there

# A few parameters, so that a run takes a fraction of a second.
SETTINGS = """source = 'Synek2019'
[[parameter]]
match = 'hood/*/central'
state = 'free'
sd = 0.3
between_sd = 0.27
[[parameter]]
match = 'sensor/*'
state = 'free'
sd_deg = 0
between_sd_deg = 4
"""


def run(*words, start=(), env=None):
    return subprocess.run([*start, PROGRAM, *map(str, words)], capture_output=True, text=True,
                          check=False, env=env)


def ask(*words):
    result = run(*words, "--json")
    assert result.returncode == 0, result.stderr
    return json.loads(result.stdout)


def group(path, name):
    with xr.open_dataset(path, group=name) as data:
        return data.load()


def draws(path):
    return group(path, "unconstrained_posterior").x.values


class WithFolder(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory(dir=MEMORY)
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.settings = self.folder / "few.toml"
        self.settings.write_text(SETTINGS)
        self.output = self.folder / "P.nc"

    def fit(self, *more, output=None, experiments=(H01,)):
        """The words of a fit of few parameters."""
        return ["fit", *experiments, "--subject", SUBJECT, "--settings", self.settings,
                "--method", "mcmc", "-o", output or self.output, *more]

    def files(self):
        """What is there; a kill may leave the temporary of a file that was being written."""
        return sorted(path.name for path in self.folder.iterdir() if ".tmp" not in path.name)

    def done(self, *words, **how):
        result = run(*words, **how)
        self.assertEqual(result.returncode, 0, result.stderr)
        return result

    def complaint(self, *words):
        """What a command that must fail says, after checking that it leaves nothing behind."""
        before = self.files()
        result = run(*words)
        self.assertNotIn(result.returncode, (0, 130), result.stdout)
        self.assertEqual(result.stdout, "")
        self.assertEqual(self.files(), before)
        return result.stderr


class Summary(WithFolder):
    made = None  # the file and its summary, which all tests share

    def setUp(self):
        super().setUp()
        if Summary.made is None:
            self.done(*self.fit("--draws", 500, "--warm-up", 500))
            Summary.made = self.output.read_bytes(), ask("posterior", "summary", self.output)
            self.assertEqual(self.files(), ["P.nc", "few.toml"])
        self.output.write_bytes(Summary.made[0])
        self.summary = Summary.made[1]

    def test_a_converged_run_says_so(self):
        self.assertTrue(self.summary["converged"])
        self.assertEqual(self.summary["advice"], [])

    def test_estimates_are_those_of_the_draws(self):
        posterior = group(self.output, "posterior")
        tilt = posterior["sensor_specimen"].sel(specimen="H01",
                                                sensor_parameter="sensor/radial").values
        told = next(p for p in self.summary["parameters"] if p["name"] == "sensor/radial")
        self.assertEqual(told["unit"], posterior["sensor_specimen"].attrs["units"])
        self.assertAlmostEqual(told["mean"], tilt.mean(), places=12)
        self.assertAlmostEqual(told["sd"], tilt.std(ddof=1), places=12)
        self.assertAlmostEqual(told["median"], np.median(tilt), delta=0.02 * told["sd"])
        self.assertAlmostEqual(told["prior_sd"], 4, delta=0.5)  # [deg], of 1000 draws

    def test_chi_square_is_that_of_the_likelihood(self):
        # log p = -chi^2/2 - sum log(s sd_i) - m/2 log 2 pi, so that chi^2 follows from log p.
        likelihood = group(self.output, "log_likelihood").force.sum("trial").values
        noise = group(self.output, "posterior").noise.values[..., 0]
        sd = group(self.output, "constant_data").force_sd.values
        chi_square = -2 * (likelihood + np.log(sd).sum() + sd.size * np.log(noise)
                           + sd.size / 2 * math.log(2 * math.pi))
        told = self.summary["experiments"][0]
        self.assertEqual(told["numbers"], sd.size)
        self.assertAlmostEqual(told["chi_square"], chi_square.mean(), places=8)

    def test_left_out_observations_lie_below_those_seen(self):
        told = self.summary["leave_one_out"]
        likelihood = group(self.output, "log_likelihood").force.values.reshape(-1, 24)
        seen = np.log(np.exp(likelihood).mean(axis=0)).sum()
        elpds = [row["elpd"] for row in told["observations"]]
        self.assertAlmostEqual(told["elpd"], sum(elpds), places=9)
        self.assertAlmostEqual(told["se"], math.sqrt(24 * np.var(elpds, ddof=1)), places=9)
        self.assertAlmostEqual(told["effective_parameters"], seen - told["elpd"], places=9)
        self.assertEqual(told["above_good_k"],
                         sum(row["k"] > told["good_k"] for row in told["observations"]))

    def test_directions_are_those_of_the_covariance(self):
        # Found in the first half of the chains, measured in the second.
        x = draws(self.output).reshape(-1, 8)
        first, second = np.split(x, 2)
        _, ways = np.linalg.eigh(np.cov(first.T))
        ratios = np.sort(np.sqrt(np.einsum("ik,ij,jk->k", ways, np.cov(second.T), ways)))
        learnt = self.summary["learnt"]
        np.testing.assert_allclose([d["sd_ratio"] for d in learnt["directions"]], ratios, rtol=1e-9)
        self.assertEqual(learnt["decided"], sum(ratios < 0.5))
        self.assertAlmostEqual(learnt["effective_parameters"], 8 - np.trace(np.cov(x.T)), places=9)

    def test_every_group_opens_with_names_and_units(self):
        shapes = {"posterior": {"chain": 4, "draw": 500, "specimen": 1},
                  "prior": {"chain": 1, "draw": 1000},
                  "unconstrained_posterior": {"chain": 4, "draw": 500, "coordinate": 8},
                  "sample_stats": {"chain": 4, "draw": 500},
                  "log_likelihood": {"chain": 4, "draw": 500, "trial": 24},
                  "posterior_predictive": {"chain": 4, "draw": 500, "trial": 24, "component": 3},
                  "observed_data": {"trial": 24, "component": 3},
                  "constant_data": {"trial": 24, "component": 3},
                  "modes": {"mode": 1, "coordinate": 8}}
        for name, shape in shapes.items():
            data = group(self.output, name)
            for dimension, length in shape.items():
                self.assertEqual(data.sizes[dimension], length, (name, dimension))
            for array in data.data_vars.values():
                self.assertIn("units", array.attrs, (name, array.name))
        self.assertEqual(group(self.output, "posterior_predictive").force.attrs["units"], "N")
        self.assertEqual(group(self.output, "posterior").sensor_specimen.attrs["units"],
                         "deg")
        stats = group(self.output, "sample_stats")
        self.assertEqual(stats.diverging.dtype, bool)
        np.testing.assert_allclose(stats.lp, stats.log_prior + stats.log_likelihood, rtol=1e-14)
        np.testing.assert_allclose(group(self.output, "log_likelihood").force.sum("trial"),
                                   stats.log_likelihood, rtol=1e-9)

    def test_text_page_and_predictions(self):
        text = self.done("posterior", "summary", self.output, "--rows", 3).stdout
        for heading in ("worst R-hat", "beside those measured", "left out one by one",
                        "best-determined parameters (3 of 8)", "directions are decided",
                        "modes, by the draws"):
            self.assertIn(heading, text)
        page = self.folder / "P.html"
        self.done("posterior", "plot", self.output, "-o", page)
        self.assertIn("posterior of H01", page.read_text())
        known = ask("posterior", "predict", self.output, H01)
        stranger = ask("posterior", "predict", self.output, B01, H02)
        self.assertTrue(known["specimen_was_fitted"])
        self.assertEqual([of["specimen_was_fitted"] for of in stranger],
                         [False, False])
        self.assertLess(known["relative_error"], stranger[0]["relative_error"])
        # The subject was calibrated on all three: none of these errors is of a stranger.
        self.assertTrue(all(of["start_has_seen_specimen"] for of in [known, *stranger]))
        result = self.done("posterior", "predict", self.output, B01)
        self.assertIn("the subject has seen specimen B01", result.stderr)
        self.assertIn("the subject that the fit started from has seen this specimen",
                      result.stdout)
        self.assertIn("the subject has seen specimen H01", text)
        self.assertIn("the subject has seen specimen H01", page.read_text())
        part = ask("posterior", "predict", self.output, H01, "--population")
        self.assertEqual(part["predicted_by"], "population")
        self.assertTrue(part["specimen_was_fitted"])


class SeenBefore(WithFolder):
    """Fits from a subject that was calibrated on the specimens, and from one that was not."""

    def fit_from(self, subject, *more):
        words = ["fit", H01, H02, "--subject", ROOT / f"data/subjects/{subject}.toml", "--settings",
                 self.settings, "-o", self.folder / "fit.h5", *more]
        return self.done(*words)

    def test_fits_and_predictions_say_what_their_subject_has_seen(self):
        result = self.fit_from("synek2019_middle", "--cross-validate", "specimen")
        for specimen in ("H01", "H02"):
            self.assertIn(f"the subject has seen specimen {specimen}: it was calibrated on "
                          "all specimens of Synek2019", result.stderr)
        left_out = [line for line in result.stdout.splitlines()
                    if "leave one" in line and "RMS error" in line]
        self.assertEqual([line.endswith("(the subject has seen this specimen)")
                          for line in left_out], [True, True])
        predicted = self.done("predict", self.folder / "fit.h5", B01)
        self.assertIn("the subject has seen specimen B01", predicted.stderr)
        self.assertIn("was never fitted", predicted.stdout)
        self.assertIn("the subject that the fit started from has seen this specimen",
                      predicted.stdout)
        self.assertTrue(ask("predict", self.folder / "fit.h5", B01)["start_has_seen_specimen"])

    def test_strangers_are_strangers(self):
        result = self.fit_from("an_chao_middle", "--cross-validate", "specimen", "--json")
        self.assertNotIn("has seen", result.stderr)
        self.assertEqual([of["start_has_seen_specimen"]
                          for of in json.loads(result.stdout)["left_out"]], [False, False])
        predicted = ask("predict", self.folder / "fit.h5", B01)
        self.assertFalse(predicted["start_has_seen_specimen"])
        part = self.done("predict", self.folder / "fit.h5", H01, "--population").stdout
        self.assertIn("was fitted; the population, of which it is a part, predicts", part)


class Samplers(WithFolder):
    def test_all_of_them_sample(self):
        words = {"hmc": [], "adaptive-metropolis": ["--thin", 3], "dream-zs": ["--walkers", 4],
                 "stretch": ["--walkers", 20, "--chains", 2],
                 "nuts": ["--temperatures", 3, "--least-temper", 0.1, "--swap-every", 2]}
        for sampler, more in words.items():
            self.done(*self.fit("--sampler", sampler, "--draws", 20, "--warm-up", 60, "--fresh",
                                "--allow-unconverged", *more))
            summary = ask("posterior", "summary", self.output, "--allow-unconverged")
            self.assertEqual(summary["sampler"], sampler)
            self.assertEqual(summary["draws"], 20)
            self.assertTrue(np.isfinite(draws(self.output)).all())
        self.assertEqual(np.shape(summary["swap_rates"]), (4, 2))
        self.assertEqual(summary["temper"][0], 1)
        self.assertAlmostEqual(summary["temper"][2], 0.1, places=12)

    def test_fixed_noise_and_several_specimens(self):
        self.done(*self.fit("--draws", 20, "--warm-up", 60, "--fixed-noise", "--threads", 2,
                            "--allow-unconverged", experiments=(H01, H02)))
        posterior = group(self.output, "posterior")
        self.assertEqual(list(posterior.specimen.values), ["H01", "H02"])
        self.assertNotIn("noise", posterior)
        self.assertEqual(posterior["spread"].dims, ("chain", "draw", "spread_kind"))
        self.assertEqual(posterior["hood_central"].dims,
                         ("chain", "draw", "hood_central_parameter"))

    def test_unconverged_run_fails_with_advice_but_leaves_its_file(self):
        result = run(*self.fit("--draws", 10, "--warm-up", 10))
        self.assertEqual(result.returncode, 1)
        self.assertTrue(result.stdout.lstrip("!").startswith("\n!! NOT CONVERGED"))
        self.assertIn("--draws 40, with which the same command continues", result.stderr)
        few = draws(self.output)
        self.assertEqual(few.shape, (4, 10, 8))
        run(*self.fit("--draws", 40, "--warm-up", 10))
        self.assertTrue((draws(self.output)[:, :10] == few).all())
        self.assertEqual(draws(self.output).shape, (4, 40, 8))
        for words in (["summary"], ["plot", "-o", self.folder / "P.html"]):
            words = ["posterior", words[0], self.output, *words[1:]]
            self.assertEqual(run(*words).returncode, 1)
            self.assertEqual(run(*words, "--allow-unconverged").returncode, 0)

    def test_temperatures_that_seldom_swap_ask_for_more(self):
        # From the posterior to the prior in one step: nearly all swaps are refused.
        result = run(*self.fit("--draws", 200, "--warm-up", 200, "--temperatures", 2))
        self.assertEqual(result.returncode, 1)
        self.assertIn("hot chains do not help cold ones", result.stderr)
        self.assertIn("more --temperatures (was 2), or a higher --least-temper", result.stderr)

    def test_ranks_draw_alike_and_fail_in_peace(self):
        if MPIEXEC is None:
            self.skipTest("no MPI")
        env = {**os.environ, "OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1",
               "OMPI_MCA_btl": "self,vader", "OMPI_MCA_mpi_yield_when_idle": "1",
               "OMPI_MCA_hwloc_base_binding_policy": "none",
               "ASAN_OPTIONS": "detect_leaks=0"}  # Open MPI keeps what it allocates
        start = [MPIEXEC, "-n", "3", "--oversubscribe"]
        other = self.folder / "Q.nc"
        words = ["--draws", 200, "--warm-up", 200, "--allow-unconverged"]
        self.done(*self.fit(*words))
        result = self.done(*self.fit(*words, output=other), start=start, env=env)
        self.assertEqual(result.stdout.count("directions are decided"), 1)
        self.assertTrue((draws(other) == draws(self.output)).all())
        result = run(*self.fit("--draws", 10, "--warm-up", 10), start=start, env=env)
        self.assertEqual(result.returncode, 1)
        self.assertEqual(result.stderr.count("NOT converged"), 1)
        self.assertNotIn("MPI_ABORT", result.stderr)


class Interruption(WithFolder):
    DRAWS = ["--draws", 400, "--thin", 12, "--warm-up", 300, "--threads", 1, "--seed", 3,
             "--checkpoint-every-s", 0.02, "--allow-unconverged", "--mode-starts", 2]

    def setUp(self):
        super().setUp()
        self.chains = self.folder / "P.nc.chains"
        self.command = [PROGRAM, *map(str, self.fit(*self.DRAWS))]

    def undisturbed(self):
        path = self.folder / "undisturbed.nc"
        start = time.monotonic()
        self.done(*self.fit(*self.DRAWS, output=path))
        return draws(path), time.monotonic() - start

    def kept(self):
        return sum(file.stat().st_size for file in self.chains.glob("group_*"))

    def stopped_by(self, number):
        """Exit code and message of a run that was told to stop once it had kept draws."""
        with subprocess.Popen(self.command, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE,
                              text=True) as process:
            while process.poll() is None and self.kept() == 0:
                time.sleep(0.005)
            process.send_signal(number)
            message = process.communicate()[1]
        return process.returncode, message

    def test_signals_keep_what_there_is_and_the_same_command_goes_on(self):
        wanted, _ = self.undisturbed()
        for number, code in ((signal.SIGINT, 130), (signal.SIGTERM, 143)):
            returned, message = self.stopped_by(number)
            self.assertEqual(returned, code, message)
            self.assertIn("the same command continues", message)
            so_far = draws(self.output)
            self.assertTrue(0 < so_far.shape[1] < 400, so_far.shape)
            self.assertTrue((so_far == wanted[:, :so_far.shape[1]]).all())
            self.assertFalse(ask("posterior", "summary", self.output,
                                 "--allow-unconverged")["complete"])
            if number == signal.SIGINT:
                self.refuses_another_run()
            self.done(*self.fit(*self.DRAWS))
            self.assertTrue((draws(self.output) == wanted).all())
            self.assertFalse(self.chains.exists())

    def refuses_another_run(self):
        told = self.complaint(*self.fit(*self.DRAWS, "--max-depth", 9))
        self.assertIn("tree depth (was 10, is 9)", told)
        self.assertIn("--fresh", told)

    def test_fresh_forgets_an_interrupted_run(self):
        self.stopped_by(signal.SIGINT)
        words = ["--draws", 20, "--warm-up", 20, "--seed", 5, "--allow-unconverged"]
        self.assertIn("seed (was 3, is 5)", self.complaint(*self.fit(*words)))
        self.done(*self.fit(*words, "--fresh"))
        self.assertEqual(draws(self.output).shape, (4, 20, 8))
        self.assertFalse(self.chains.exists())

    def test_stopped_in_its_search_it_leaves_nothing(self):
        command = [*self.command, "--fresh"]
        command[command.index("--mode-starts") + 1] = "5000000"  # hours of searches
        code, _, message = stopped(command, signal.SIGINT, lambda code, _: code == 130)
        self.assertEqual(code, 130)
        self.assertIn("stopped in the search for modes", message)
        self.assertEqual(self.files(), ["few.toml"])

    def test_two_processes_do_not_share_a_run(self):
        with subprocess.Popen(self.command, stdout=subprocess.DEVNULL,
                              stderr=subprocess.DEVNULL) as process:
            while process.poll() is None and self.kept() == 0:
                time.sleep(0.005)
            process.send_signal(signal.SIGSTOP)
            for more in ([], ["--fresh"]):
                told = self.complaint(*self.fit(*self.DRAWS, *more))
                self.assertIn("another process is sampling", told)
            process.kill()
        self.assertGreater(self.kept(), 0)

    def test_killed_twenty_times_it_ends_with_the_same_draws(self):
        wanted, whole = self.undisturbed()
        moments, span, kills, kept = random.Random(11), 1.2 * whole, 0, []
        while kills < 20:
            with subprocess.Popen(self.command, stdout=subprocess.DEVNULL,
                                  stderr=subprocess.DEVNULL) as process:
                try:
                    # At least the search for modes, or it would never come further.
                    self.assertEqual(process.wait(moments.uniform(0.1, 1) * span / 4), 0)
                    self.assertTrue((draws(self.output) == wanted).all())
                    self.output.unlink()
                    span /= 1.2  # faster than expected: kill it sooner
                except subprocess.TimeoutExpired:
                    process.kill()
                    kills += 1
                    if kept and self.kept() == kept[-1]:
                        span *= 1.2  # slower than expected: let it come further
            kept.append(self.kept())
        self.assertGreater(len(set(kept)), 5, kept)
        print(f"20 kills of {whole:.2f} s, bytes kept: {kept}")
        self.done(*self.fit(*self.DRAWS))
        self.assertTrue((draws(self.output) == wanted).all())
        self.assertEqual(self.files(), ["P.nc", "few.toml", "undisturbed.nc"])


class BadInput(WithFolder):
    def test_fits_say_what_was_wanted(self):
        cases = ((["-o", self.folder / "P.h5"], "wanted an output that ends in .nc"),
                 (["--sampler", "gibbs"], "adaptive-metropolis, dream-zs, stretch, hmc, nuts, got \"gibbs\" (--sampler)"),
                 (["--chains", 0], "--chains"),
                 (["--sampler", "stretch", "--walkers", 4], "at least 10, got 4"),
                 (["--walkers", 3], "nuts moves one chain, got 3"),
                 (["--sampler", "dream-zs", "--walkers", 2], "at least 3 chains, got 2"),
                 (["--temperatures", 3, "--least-temper", 1], "least temper must be in 0 .. below"),
                 (["--target-acceptance", 1], "--target-acceptance"),
                 (["--max-depth", 0], "--max-depth"), (["--swap-every", 0], "--swap-every"),
                 (["-o", "/proc/thenar/P.nc"], "/proc/thenar"))
        for more, wanted in cases:
            with self.subTest(more=more):
                words = self.fit(*more)
                if "-o" in more:
                    del words[words.index("-o"):words.index("-o") + 2]
                self.assertIn(wanted, self.complaint(*words))

    def test_another_file_is_not_overwritten(self):
        self.output.write_text("my notes")
        self.assertIn("is not overwritten", self.complaint(*self.fit()))
        self.assertEqual(self.output.read_text(), "my notes")

    def test_summaries_say_what_is_wrong_with_a_file(self):
        self.done(*self.fit("--draws", 20, "--warm-up", 20, "--allow-unconverged"))
        whole = self.output.read_bytes()
        fit = self.folder / "fit.h5"
        self.done("fit", H01, "--subject", SUBJECT, "--settings", self.settings, "-o", fit)
        files = {"none.nc": None, "garbage.nc": b"no netCDF at all", "empty.nc": b"",
                 "half.nc": whole[:len(whole) // 2], "head.nc": whole[:4096],
                 "fit.h5": fit.read_bytes()}
        for name, content in files.items():
            path = self.folder / name
            if content is not None:
                path.write_bytes(content)
            for words in (["summary", path], ["plot", path, "-o", self.folder / "P.html"],
                          ["predict", path, H01]):
                with self.subTest(name=name, words=words[0]):
                    self.assertIn(name, self.complaint("posterior", *words))

    def test_draws_that_are_not_finite_are_refused(self):
        self.done(*self.fit("--draws", 20, "--warm-up", 20, "--allow-unconverged"))
        # Whoever seals a file anew may write anything: the checksum is no proof of sense.
        sealed = self.output.read_bytes()
        self.output.write_bytes(sealed[:sealed.rindex(b"\nthenar sha256 ")])
        with h5py.File(self.output, "a") as file:
            file["unconstrained_posterior/x"][1, 3, 2] = float("nan")
        self.assertIn("its checksum (SHA-256) is missing",
                      self.complaint("posterior", "summary", self.output))
        bare = self.output.read_bytes()
        digest = hashlib.sha256(bare).hexdigest().encode()
        self.output.write_bytes(bare + b"\nthenar sha256 " + digest + b"\n")
        self.assertIn("P.nc:1: 'unconstrained_posterior/x': it has numbers that are not finite",
                      self.complaint("posterior", "summary", self.output))


if __name__ == "__main__":
    unittest.main()
