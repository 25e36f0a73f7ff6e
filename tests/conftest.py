"""Shapes and types of every annotated public function are enforced while the tests run."""

from jaxtyping import install_import_hook

install_import_hook(["design", "fem", "estimator"], "beartype.beartype")
