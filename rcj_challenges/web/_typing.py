"""Settings for the type checker only: its Django plug-in needs a module with some."""

import tempfile
from pathlib import Path

from rcj_challenges.web.config import SiteConfig
from rcj_challenges.web.settings import settings_for

globals().update(settings_for(SiteConfig(folder=Path(tempfile.gettempdir())), "type checking"))
