BEGIN TRANSACTION;
CREATE TABLE checked (
	archive VARCHAR NOT NULL, 
	scenario VARCHAR NOT NULL, 
	level VARCHAR NOT NULL, 
	findings JSON NOT NULL, 
	PRIMARY KEY (archive, scenario)
);
CREATE TABLE job (
	id VARCHAR NOT NULL, 
	state VARCHAR NOT NULL, 
	job JSON NOT NULL, 
	summary JSON NOT NULL, 
	files JSON NOT NULL, 
	doubtful BOOLEAN NOT NULL, 
	complaint VARCHAR NOT NULL, 
	ended_at DATETIME NOT NULL, 
	PRIMARY KEY (id)
);
INSERT INTO "job" VALUES('44f2a63c4255863d1d8c512638e52ece','played','{"scenario": "e18fc20a5e5f80ddf8459f11587a3b24049ab5e958129b7d9d1c833cddbd64cb", "seats": {"blue": [{"archive": "f7c6e26b61e0095e92404a4807ad70146399bca265ecccbc28804a576e37d533", "digest": "d704a4faad46402735a373f2ebdb58f33caa9351fb3ee027e2f0af3ea33b5a94", "name": "Team cid"}], "yellow": [{"archive": "a87e0ef74b1fc928c3d35a0cff1725c952e3567ddef24e4401eb63608e1bedc3", "digest": "c0103872fb07b397eee6bed177d05082dd04e7f79de08e683ecc783941208ae9", "name": "Team bee"}]}, "names": {"blue": "Team cid", "yellow": "Team bee"}, "seed": 369412724, "versions": {"rcj_challenges": "0.1.0", "python": "CPython 3.11.7", "mujoco": "4.0.0", "numpy": "2.3.5", "system": "Linux", "machine": "x86_64"}, "match_id": 0, "records": "replay", "sandbox": "off"}','{"score": {"blue": 1, "yellow": 1}, "ranking": [{"team": "blue", "place": 1, "values": [1]}, {"team": "yellow", "place": 1, "values": [1]}], "digest": "369412724 {''blue'': 1, ''yellow'': 1} []", "wall_s": 1.0, "simulated_s": 2.0, "versions": {"rcj_challenges": "0.1.0", "python": "CPython 3.11.7", "mujoco": "4.0.0", "numpy": "2.3.5", "system": "Linux", "machine": "x86_64"}, "faults": [], "is_timed": false}','{"result.json": 386}',0,'','2026-11-29 00:44:48.511226');
CREATE TABLE meta (
	"key" VARCHAR NOT NULL, 
	value VARCHAR NOT NULL, 
	PRIMARY KEY ("key")
);
INSERT INTO "meta" VALUES('store_version','2');
CREATE TABLE played (
	fixture VARCHAR NOT NULL, 
	job_id VARCHAR NOT NULL, 
	sides VARCHAR NOT NULL, 
	outcome JSON NOT NULL, 
	submissions JSON NOT NULL, 
	played_at DATETIME NOT NULL, 
	PRIMARY KEY (fixture), 
	FOREIGN KEY(job_id) REFERENCES job (id)
);
INSERT INTO "played" VALUES('league/round2/cid-bee','44f2a63c4255863d1d8c512638e52ece','cid bee','[[1, 1], []]','{"cid": "f7c6e26b61e0095e92404a4807ad70146399bca265ecccbc28804a576e37d533", "bee": "a87e0ef74b1fc928c3d35a0cff1725c952e3567ddef24e4401eb63608e1bedc3"}','2026-11-29 00:44:48.511226');
CREATE TABLE ruling (
	id INTEGER NOT NULL, 
	kind VARCHAR NOT NULL, 
	fixture VARCHAR NOT NULL, 
	team VARCHAR NOT NULL, 
	sides JSON NOT NULL, 
	scores JSON NOT NULL, 
	last_rounds JSON NOT NULL, 
	reason VARCHAR NOT NULL, 
	at DATETIME NOT NULL, 
	PRIMARY KEY (id)
);
INSERT INTO "ruling" VALUES(1,'corrected','league/round1/ada-cid','','[["ada"], ["cid"]]','[0, 1]','{}','as seen','2026-11-29 00:44:47.465157');
INSERT INTO "ruling" VALUES(2,'corrected','league/round1/dan-eve','','[["dan"], ["eve"]]','[0, 1]','{}','as seen','2026-11-29 00:44:47.501108');
INSERT INTO "ruling" VALUES(3,'corrected','league/round1/bee-fay','','[["bee"], ["fay"]]','[0, 0]','{}','as seen','2026-11-29 00:44:47.532310');
CREATE TABLE submission (
	id INTEGER NOT NULL, 
	team VARCHAR NOT NULL, 
	purpose VARCHAR NOT NULL, 
	archive VARCHAR NOT NULL, 
	file VARCHAR NOT NULL, 
	name VARCHAR NOT NULL, 
	received_at DATETIME NOT NULL, 
	PRIMARY KEY (id)
);
INSERT INTO "submission" VALUES(1,'ada','','000ceca089349b0184fb02179d15937bdf80e25e48abc8adfbffcbb9f9bc4b91','000ceca089349b0184fb02179d15937bdf80e25e48abc8adfbffcbb9f9bc4b91.zip','Team ada','2026-11-29 00:44:47.976716');
INSERT INTO "submission" VALUES(2,'bee','','a87e0ef74b1fc928c3d35a0cff1725c952e3567ddef24e4401eb63608e1bedc3','a87e0ef74b1fc928c3d35a0cff1725c952e3567ddef24e4401eb63608e1bedc3.zip','Team bee','2026-11-29 00:44:48.019757');
INSERT INTO "submission" VALUES(3,'cid','','f7c6e26b61e0095e92404a4807ad70146399bca265ecccbc28804a576e37d533','f7c6e26b61e0095e92404a4807ad70146399bca265ecccbc28804a576e37d533.zip','Team cid','2026-11-29 00:44:48.029729');
INSERT INTO "submission" VALUES(4,'dan','','75e6116f023b3849e1ee1d2b0a4d2a9cb1e58a0c2d4d60fda6a71019a52555bc','75e6116f023b3849e1ee1d2b0a4d2a9cb1e58a0c2d4d60fda6a71019a52555bc.zip','Team dan','2026-11-29 00:44:48.043180');
INSERT INTO "submission" VALUES(5,'eve','','c75c7da1be9dc82bd8e1c981c57f643bbc4f404047d3112db1e67a6e4ece7b6f','c75c7da1be9dc82bd8e1c981c57f643bbc4f404047d3112db1e67a6e4ece7b6f.zip','Team eve','2026-11-29 00:44:48.068538');
INSERT INTO "submission" VALUES(6,'fay','','570863d36ded79f9766a66583346b40db319a5588cc565d058c38af00803a0c3','570863d36ded79f9766a66583346b40db319a5588cc565d058c38af00803a0c3.zip','Team fay','2026-11-29 00:44:48.075094');
COMMIT;