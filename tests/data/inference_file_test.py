"""Opens what write_inference() wrote with xarray, by both libraries, as az.from_netcdf() walks it.

inference_file_test.py DATA_TEST

The sample and its values are those of example() in inference_file_test.cpp.
"""
import os
import pathlib
import subprocess
import sys
import tempfile
from datetime import datetime

import h5netcdf
import netCDF4
import numpy as np
import xarray as xr

# The groups of the InferenceData schema; ArviZ warns about others.
SCHEMA = {"posterior", "posterior_predictive", "predictions", "log_likelihood", "log_prior",
          "sample_stats", "prior", "prior_predictive", "sample_stats_prior", "observed_data",
          "constant_data", "predictions_constant_data", "unconstrained_posterior"}


def from_netcdf(path, engine):
    """Groups and attributes, as ArviZ finds and loads them."""
    if engine == "h5netcdf":
        with h5netcdf.File(path, mode="r") as file:
            names = list(file.groups)
    else:
        with netCDF4.Dataset(path, mode="r") as file:
            names = list(file.groups)
    groups = {}
    for name in names:
        with xr.open_dataset(path, group=f"//{name}", engine=engine) as data:  # since 0.18
            groups[name] = data.load()
        with xr.open_dataset(path, group=name, engine=engine) as data:
            assert data.load().identical(groups[name])
    with xr.open_dataset(path, engine=engine) as data:
        return groups, data.load().attrs


def check(path, engine):
    groups, attributes = from_netcdf(path, engine)
    assert set(groups) == {"posterior", "sample_stats", "observed_data"} and set(groups) <= SCHEMA
    assert attributes["seed"] == "7" and attributes["note"] == "µ, two\nlines", attributes["note"]
    assert attributes["inputs"] == 200000 * "x" and attributes["nothing"] == ""
    for group in groups.values():
        assert group.attrs["inference_library"] == "thenar"
        age = datetime.now().timestamp() - datetime.fromisoformat(
            group.attrs["created_at"]).timestamp()
        assert -1 <= age < 600, group.attrs["created_at"]
        assert group.attrs["inference_library_version"].count(".") == 2

    posterior = groups["posterior"]
    assert dict(posterior.sizes) == {"chain": 2, "draw": 3, "parameter": 2}
    for name, length in (("chain", 2), ("draw", 3)):
        assert posterior.indexes[name].equals(type(posterior.indexes[name])(range(length)))
        assert posterior[name].dtype == np.int64
    assert list(posterior["parameter"].values) == ["axis/CMC1_FE/point", "größe"]
    x = posterior["x"]
    assert x.dims == ("chain", "draw", "parameter") and x.dtype == np.float64
    assert x.attrs == {"units": "mm", "long_name": "place of an axis"}, x.attrs
    assert x.sel(chain=1, draw=2, parameter="größe").item() == 121
    assert x.sel(chain=0, draw=1, parameter="axis/CMC1_FE/point").item() == 10
    assert posterior["noise"].attrs == {"units": "N"}
    assert posterior["noise"].values.tolist() == [[0.1, 1e-300, -5], [3, 1e300, 2]]

    stats = groups["sample_stats"]
    assert stats["diverging"].dtype == bool and stats["diverging"].dims == ("chain", "draw")
    assert stats["diverging"].values.tolist() == [[False, True, False], [False, False, True]]
    assert stats["tree_depth"].dtype == np.int64
    assert stats["tree_depth"].values.tolist() == [[1, 2, 3], [4, 5, 10**9]]

    observed = groups["observed_data"]
    assert list(observed["trial"].values) == ["key pinch", ""]
    assert observed["force"].values[0] == 4 and np.isnan(observed["force"].values[1])
    assert observed["scale"].dims == () and observed["scale"].item() == 0.25
    assert observed["empty"].shape == (0,)


with tempfile.TemporaryDirectory() as folder:
    sample = str(pathlib.Path(folder) / "sample.nc")
    subprocess.run([sys.argv[1], "--gtest_filter=InferenceFileTest.LeavesASampleForOtherPrograms"],
                   env={**os.environ, "THENAR_INFERENCE_SAMPLE": sample}, check=True,
                   stdout=subprocess.DEVNULL)
    for engine in ("netcdf4", "h5netcdf"):
        check(sample, engine)
        print(f"{engine}: as written")
