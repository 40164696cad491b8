#!/usr/bin/env python3
"""Compares the exact films of nacre-film-error with PyPI's tmm.

    check_tmm.py NACRE_FILM_ERROR WORK         compare 400 random films (installs tmm into WORK)
    check_tmm.py NACRE_FILM_ERROR WORK --data  print a few films with tmm's results as CSV, for tests/spectral/data

Exit status 77: tmm cannot be had, nothing was compared.
"""
import pathlib
import subprocess
import sys
import venv

TOLERANCE = 1e-11  # both sum a handful of terms near 1 in double precision; grazing metals lose three digits


def interpreter(work):
    python = work / "tmm-environment" / "bin" / "python"
    if not python.exists():
        try:
            venv.create(work / "tmm-environment", with_pip=True)
        except subprocess.CalledProcessError:
            print("skipped: no virtual environment can be made; is Debian's python3-venv installed?")
            sys.exit(77)
    installed = subprocess.run([python, "-m", "pip", "install", "--quiet", "tmm==0.2.0", "numpy"], capture_output=True, text=True)
    if installed.returncode:
        print(installed.stderr[-2000:])
        print("skipped: tmm cannot be installed; is the package index reachable?")
        sys.exit(77)
    return python


def compare(program, print_data):
    import numpy
    import tmm

    random = numpy.random.default_rng(1)
    count = 24 if print_data else 400
    columns = ["index", "substrate_n", "substrate_k", "thickness_nm", "cos_theta", "wavelength_nm"]
    films = numpy.column_stack([
        random.uniform(1.1, 2.5, count), random.uniform(0.05, 4, count), random.uniform(0, 7, count) * (random.random(count) < 0.6),
        random.uniform(0, 3000, count), random.uniform(0.01, 1, count), random.uniform(380, 780, count)])
    results = []
    for index, n, k, thickness, cosine, wavelength in films:
        arguments = [1, index, n + 1j * k], [numpy.inf, thickness, numpy.inf], numpy.arccos(cosine), wavelength
        results.append([tmm.coh_tmm(polarisation, *arguments)["R"] for polarisation in "sp"])
    if print_data:
        print(",".join(columns + ["r_s", "r_p"]))
        for film, result in zip(films, results):
            print(",".join(f"{value:.17g}" for value in [*film, *result]))
        return
    text = ",".join(columns) + "\n" + "".join(",".join(f"{value:.17g}" for value in film) + "\n" for film in films)
    output = subprocess.run([program, "--reflectances"], input=text, capture_output=True, text=True, check=True).stdout
    own = numpy.array([[float(cell) for cell in line.split(",")] for line in output.split()[1:]])
    worst = numpy.abs(own - results).max()
    print(f"{count} films, largest difference of a reflectance: {worst:.2g}")
    sys.exit(0 if worst <= TOLERANCE else 1)


if __name__ == "__main__":
    if "--inside" in sys.argv:
        compare(sys.argv[1], "--data" in sys.argv)
    else:
        work = pathlib.Path(sys.argv[2])
        work.mkdir(parents=True, exist_ok=True)
        command = [interpreter(work), __file__, *sys.argv[1:], "--inside"]
        sys.exit(subprocess.run(command).returncode)
