"""rosbag2's SQLite storage by Python's sqlite3, after the schema of rosbag2_storage_sqlite3."""
import base64
import json
import os
import shutil
import sqlite3
import subprocess
import sys

SCHEMA = """
CREATE TABLE schema(schema_version INTEGER PRIMARY KEY, ros_distro TEXT NOT NULL);
CREATE TABLE metadata(id INTEGER PRIMARY KEY, metadata_version INTEGER NOT NULL, metadata TEXT NOT NULL);
CREATE TABLE topics(id INTEGER PRIMARY KEY, name TEXT NOT NULL, type TEXT NOT NULL,
  serialization_format TEXT NOT NULL, offered_qos_profiles TEXT NOT NULL);
CREATE TABLE messages(id INTEGER PRIMARY KEY, topic_id INTEGER NOT NULL, timestamp INTEGER NOT NULL,
  data BLOB NOT NULL);
CREATE INDEX timestamp_idx ON messages (timestamp ASC);
INSERT INTO schema VALUES (3, 'humble');
"""

METADATA = """rosbag2_bagfile_information:
  version: 5
  storage_identifier: sqlite3
  relative_file_paths:
    - {file}
  compression_format: {format}
  compression_mode: {mode}
"""


def write(path, messages, pack=lambda data: data):
    if os.path.exists(path):
        os.remove(path)
    database = sqlite3.connect(path)
    database.executescript("PRAGMA page_size = 1024;" + SCHEMA)
    topics = {}
    for m in messages:
        if m["topic"] not in topics:
            topics[m["topic"]] = len(topics) + 1
            row = (topics[m["topic"]], m["topic"], m["type"], "cdr", "")
            database.execute("INSERT INTO topics VALUES (?, ?, ?, ?, ?)", row)
        row = (topics[m["topic"]], int(m["time"]), pack(base64.b64decode(m["data"])))
        database.execute("INSERT INTO messages(topic_id, timestamp, data) VALUES (?, ?, ?)", row)
    database.commit()
    database.close()


def folder(out, name, file, mode):
    path = f"{out}/{name}"
    shutil.rmtree(path, ignore_errors=True)
    os.makedirs(path)
    with open(path + "/metadata.yaml", "w") as text:
        text.write(METADATA.format(file=file, format="zstd", mode=mode))
    return path


def zstd(data):
    return subprocess.run(["zstd", "-q", "-c"], input=data, stdout=subprocess.PIPE, check=True).stdout


def main(out, lines):
    messages = [json.loads(line) for line in open(lines)]
    write(out + "/tf.db3", messages)
    # rosbag2's compression of each message, and of the file.
    write(folder(out, "zstd_messages", "drive_0.db3", "MESSAGE") + "/drive_0.db3", messages, zstd)
    path = folder(out, "zstd_file", "drive_0.db3.zstd", "FILE") + "/drive_0.db3"
    write(path, messages)
    subprocess.run(["zstd", "-q", "--rm", path, "-o", path + ".zstd"], check=True)


if __name__ == "__main__":
    main(*sys.argv[1:])
