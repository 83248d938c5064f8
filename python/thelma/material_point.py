"""Stresses of homogeneous tests by the program itself, `thelma --material-point`: one process for as many
materials and tests as are asked for."""

import json
import subprocess

from thelma.errors import ThelmaError


class MaterialPoint:
    """The materials of a parameter file; to be closed, or used with `with`.

    A test is a dictionary: `name`, `mode` (uniaxial, pure shear, equibiaxial), `stress unit` and `columns`,
    each with its `unit` and `values`: stretch and, if there are any, time, temperature and field.
    """

    def __init__(self, program, scene, options=()):
        self.process = subprocess.Popen([str(program), "--material-point", str(scene), *options], text=True,
                                        stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=subprocess.PIPE)

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.close()

    def close(self):
        """Ends the process."""
        self.process.communicate()

    def ask(self, **request):
        """The answer to a request."""
        try:
            self.process.stdin.write(json.dumps(request) + "\n")
            self.process.stdin.flush()
        except BrokenPipeError:  # it has ended, and said why
            pass
        line = self.process.stdout.readline()
        if not line:
            sentences = self.process.stderr.read().strip()
            raise ThelmaError(sentences.removeprefix("thelma: ") or "the program ended without an answer")
        answer = json.loads(line)
        if "error" in answer:
            raise ThelmaError(answer["error"])
        return answer

    def stresses(self, tests, sets=((),), material=""):
        """For every set of changes, `Materials/.../Entry=value`, the stresses of every test; or a
        ThelmaError that says why there are none."""
        answer = self.ask(material=material, tests=list(tests), sets=[list(changes) for changes in sets])
        return [ThelmaError(one["error"]) if isinstance(one, dict) else one for one in answer["stresses"]]
