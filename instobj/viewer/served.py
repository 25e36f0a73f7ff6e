"""Pages served on this machine: whom they answer, and what they may ask for."""

from __future__ import annotations

import ipaddress

_LOCAL_NAMES = ("localhost", "127.0.0.1", "::1")


def is_loopback(address: str) -> bool:
    """Return whether only this machine reaches an address."""
    if address == "localhost":
        return True
    try:
        return ipaddress.ip_address(address).is_loopback
    except ValueError:
        return False


def refusal(host: str, origin: str | None, address: str) -> str | None:
    """Return why a request is refused, by its Host and Origin headers; None where it is not.

    Names that are not ours are refused (a foreign page may point its own name here), and pages of other
    origins.
    """
    # The address itself as well: 127.0.0.2 is printed as 127.0.0.2, and a foreign name cannot be it.
    if is_loopback(address) and _name(host) not in (*_LOCAL_NAMES, address):
        return f"this server is not {host}\n"
    if origin is not None and origin != f"http://{host}":
        return "a page of another origin may not ask\n"
    return None


def page_headers(host: str) -> dict[str, str]:
    """Return the headers of a page that runs its own program and asks its own server alone."""
    policy = (
        "default-src 'none'; script-src 'self'; style-src 'unsafe-inline'; img-src data:; "
        f"connect-src 'self' ws://{host}; frame-ancestors 'none'; base-uri 'none'"
    )
    return {"Content-Security-Policy": policy, "Referrer-Policy": "no-referrer"}


def _name(host: str) -> str:
    """Return a Host header without its port."""
    if host.startswith("["):
        return host[1:].partition("]")[0]
    return host.partition(":")[0]
