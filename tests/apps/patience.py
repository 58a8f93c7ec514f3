"""Time limits that hold under sanitizers, too: THENAR_PATIENCE times as long as tests say."""
import os
import subprocess

FACTOR = float(os.environ.get("THENAR_PATIENCE", "1"))
communicate, wait = subprocess.Popen.communicate, subprocess.Popen.wait


def patient_communicate(self, input=None, timeout=None):
    return communicate(self, input, timeout and timeout * FACTOR)


def patient_wait(self, timeout=None):
    return wait(self, timeout and timeout * FACTOR)


subprocess.Popen.communicate, subprocess.Popen.wait = patient_communicate, patient_wait
