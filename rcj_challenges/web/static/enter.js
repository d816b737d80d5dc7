// The QR code of a card has the code behind #: it is filled in here, and never sent as part of an address.
"use strict";
const code = decodeURIComponent(location.hash.slice(1));
if (code) {
  document.getElementById("code").value = code;
  history.replaceState(null, "", location.pathname);
  document.getElementById("enter").requestSubmit();
}
