"""Headers and refusals on all pages."""

from __future__ import annotations

from collections.abc import Callable

from csp.middleware import CSPMiddleware, PolicyParts
from django.http import HttpRequest, HttpResponse, HttpResponseBase

from rcj_challenges.web.settings import POLICY

_SAFE = frozenset({"GET", "HEAD", "OPTIONS"})


class PolicyMiddleware(CSPMiddleware):
    """Sends the policy; the lists of organizers are without Trusted Types, on which their jQuery fails."""

    def get_policy_parts(
        self, request: HttpRequest, response: HttpResponseBase, report_only: bool = False
    ) -> PolicyParts:
        """Return the policy of an answer."""
        parts = super().get_policy_parts(request, response, report_only)
        if request.path_info.startswith("/admin/") and parts.config is None:
            parts.config = {name: value for name, value in POLICY.items() if name != "require-trusted-types-for"}
        return parts


def fetch_metadata(
    get_response: Callable[[HttpRequest], HttpResponseBase],
) -> Callable[[HttpRequest], HttpResponseBase]:
    """Refuse what another site's page sends, where the browser states it; over plain HTTP it does not."""

    def middleware(request: HttpRequest) -> HttpResponseBase:
        site = request.headers.get("Sec-Fetch-Site", "none")
        if request.method not in _SAFE and site not in {"none", "same-origin"}:
            return HttpResponse("This was sent by a page of another site.", status=403, content_type="text/plain")
        response = get_response(request)
        response.setdefault("Cache-Control", "no-store" if request.session.session_key else "no-cache")
        return response

    return middleware
