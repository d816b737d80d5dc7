"""Django's settings, made from those of a site."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Any
from urllib.parse import unquote, urlsplit

if TYPE_CHECKING:
    from rcj_challenges.web.config import SiteConfig

_DAY_S = 24 * 3600
SESSION_S = 12 * 3600
POLICY: dict[str, Any] = {
    "default-src": ["'none'"],
    "script-src": ["'self'"],
    "style-src": ["'self'"],
    "img-src": ["'self'"],
    "connect-src": ["'self'"],
    "form-action": ["'self'"],
    "frame-ancestors": ["'none'"],
    "base-uri": ["'none'"],
    "require-trusted-types-for": ["'script'"],
}
"""What browsers may load on every page; nothing inline, nothing from elsewhere."""


def settings_for(config: SiteConfig, secret_key: str) -> dict[str, Any]:
    """Return Django's settings."""
    secure = config.https
    return {
        "SECRET_KEY": secret_key,
        "DEBUG": False,
        "ALLOWED_HOSTS": list(config.hosts),
        "DATABASES": {"default": _database(config)},
        "DEFAULT_AUTO_FIELD": "django.db.models.BigAutoField",
        "INSTALLED_APPS": [
            "django.contrib.admin",
            "django.contrib.auth",
            "django.contrib.contenttypes",
            "django.contrib.sessions",
            "django.contrib.messages",
            "django.contrib.staticfiles",
            "csp",
            "rcj_challenges.web",
        ],
        "MIDDLEWARE": [
            "rcj_challenges.web.middleware.PolicyMiddleware",
            "django.middleware.security.SecurityMiddleware",
            "whitenoise.middleware.WhiteNoiseMiddleware",
            "django.contrib.sessions.middleware.SessionMiddleware",
            "django.middleware.locale.LocaleMiddleware",
            "django.middleware.http.ConditionalGetMiddleware",
            "django.middleware.common.CommonMiddleware",
            "rcj_challenges.web.middleware.fetch_metadata",
            "django.middleware.csrf.CsrfViewMiddleware",
            "django.contrib.auth.middleware.AuthenticationMiddleware",
            "django.contrib.messages.middleware.MessageMiddleware",
            "django.middleware.clickjacking.XFrameOptionsMiddleware",
        ],
        "ROOT_URLCONF": "rcj_challenges.web.urls",
        "AUTH_USER_MODEL": "web.Account",
        "PASSWORD_HASHERS": ["rcj_challenges.web.accounts.Argon2"],
        "AUTH_PASSWORD_VALIDATORS": [
            {"NAME": "django.contrib.auth.password_validation.MinimumLengthValidator", "OPTIONS": {"min_length": 10}},
            {"NAME": "django.contrib.auth.password_validation.CommonPasswordValidator"},
        ],
        "TEMPLATES": [
            {
                "BACKEND": "django.template.backends.jinja2.Jinja2",
                "DIRS": [Path(__file__).parent / "templates"],
                "OPTIONS": {"environment": "rcj_challenges.web.pages.environment"},
            },
            {
                "BACKEND": "django.template.backends.django.DjangoTemplates",
                "APP_DIRS": True,
                "OPTIONS": {
                    "context_processors": [
                        "django.template.context_processors.request",
                        "django.contrib.auth.context_processors.auth",
                        "django.contrib.messages.context_processors.messages",
                    ]
                },
            },
        ],
        "TIME_ZONE": config.time_zone,
        "USE_TZ": True,
        "LANGUAGE_CODE": "en",
        "LANGUAGES": [("en", "English")],  # those that there are translations for
        "FORMAT_MODULE_PATH": "rcj_challenges.web.formats",
        "LOCALE_PATHS": [Path(__file__).parent / "locale"],
        "STATIC_URL": "/static/",
        "STATICFILES_DIRS": [Path(__file__).parent / "static"],
        "WHITENOISE_USE_FINDERS": True,
        "WHITENOISE_ALLOW_ALL_ORIGINS": False,
        "CONTENT_SECURITY_POLICY": {"DIRECTIVES": POLICY},
        "FILE_UPLOAD_MAX_MEMORY_SIZE": 64_000,
        "FILE_UPLOAD_TEMP_DIR": config.folder / "incoming",
        "DATA_UPLOAD_MAX_MEMORY_SIZE": 64_000,
        "SESSION_COOKIE_AGE": SESSION_S,
        "SESSION_COOKIE_SECURE": secure,
        "SESSION_COOKIE_NAME": "__Host-session" if secure else "session",
        "SESSION_COOKIE_SAMESITE": "Lax",
        "CSRF_COOKIE_SECURE": secure,
        "CSRF_COOKIE_NAME": "__Host-csrf" if secure else "csrf",
        "CSRF_COOKIE_HTTPONLY": True,
        "SECURE_SSL_REDIRECT": False,  # the proxy in front does it
        "SECURE_HSTS_SECONDS": 365 * _DAY_S if secure else 0,
        "SECURE_REFERRER_POLICY": "same-origin",
        "X_FRAME_OPTIONS": "DENY",
        "LOGGING": {
            "version": 1,
            "disable_existing_loggers": False,
            "handlers": {"stderr": {"class": "logging.StreamHandler"}},
            "loggers": {"django": {"handlers": ["stderr"], "level": "ERROR", "propagate": False}},
        },
    }


def _database(config: SiteConfig) -> dict[str, Any]:
    if config.is_sqlite:
        return {
            "ENGINE": "django.db.backends.sqlite3",
            "NAME": config.folder / "site.sqlite3",
            "OPTIONS": {
                "transaction_mode": "IMMEDIATE",
                "timeout": 20,
                # A receipt is given only for what a power cut cannot take away.
                "init_command": "PRAGMA journal_mode=WAL; PRAGMA synchronous=FULL;",
            },
        }
    parts = urlsplit(config.database)
    return {
        "ENGINE": "django.db.backends.postgresql",
        "NAME": parts.path.lstrip("/"),
        "USER": unquote(parts.username or ""),
        "PASSWORD": unquote(parts.password or ""),
        "HOST": unquote(parts.hostname or ""),
        "PORT": str(parts.port or ""),
        "CONN_MAX_AGE": 0,
        "CONN_HEALTH_CHECKS": True,  # a server that was restarted costs no request
        "OPTIONS": {
            "pool": {"min_size": 1, "max_size": max(10, config.lanes + 2)},
            # A process that is suspended or cut off within a transaction must not keep its locks.
            "options": "-c idle_in_transaction_session_timeout=20s",
        },
    }
