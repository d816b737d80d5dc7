// The QR code of a card has the code behind #: it is filled in here, and never sent as part of an address.
// It is not sent by itself: a link could otherwise sign a browser in as another team.
"use strict";
const code = decodeURIComponent(location.hash.slice(1));
if (code) {
  document.getElementById("code").value = code;
  history.replaceState(null, "", location.pathname);
}
