"""A Haply Inverse Service without a device: a cursor without mass follows a script of time and keeps each force it is told.

It speaks what coapt-live needs of RFC 6455 (text, close) and of Haply's JSON (clients/live/haply_message.h).
"""

import base64
import hashlib
import json
import socket
import struct
import threading
import time

GUID = b"258EAFA5-E914-47DA-95CA-C5AB0DC85B11"


def received(connection, count):
    """Exactly so many bytes; fewer at the end of the stream."""
    read = b""
    while len(read) < count:
        part = connection.recv(count - len(read))
        if not part:
            break
        read += part
    return read


def read_frame(connection):
    """(opcode, payload) of a client's frame, which is masked; none at the end of the stream."""
    head = received(connection, 2)
    if len(head) < 2:
        return None
    length = head[1] & 0x7F
    if length == 126:
        (length,) = struct.unpack(">H", received(connection, 2))
    mask = received(connection, 4)
    payload = received(connection, length)
    return head[0] & 0x0F, bytes(byte ^ mask[i % 4] for i, byte in enumerate(payload))


def frame(payload, opcode=1):
    head = bytes([0x80 | opcode])
    length = len(payload)
    if length < 126:
        return head + bytes([length]) + payload
    if length < 1 << 16:
        return head + b"\x7e" + struct.pack(">H", length) + payload
    return head + b"\x7f" + struct.pack(">Q", length) + payload


class HaplyService:
    """Listens at .url while in use.

    `cursor(seconds)` is ((x, y, z) in metres, pressed), a text to send without waiting for an answer, or None to hang up.
    """

    def __init__(self, cursor, device_id="0123"):
        self.cursor, self.device_id = cursor, device_id
        self.felt = []  # (seconds, place, pressed, force)
        self.listener = socket.create_server(("127.0.0.1", 0))
        self.url = f"ws://127.0.0.1:{self.listener.getsockname()[1]}"
        self.thread = threading.Thread(target=self.serve, daemon=True)

    def __enter__(self):
        self.thread.start()
        return self

    def __exit__(self, *_):
        self.listener.close()
        self.thread.join(10)

    def serve(self):
        try:
            connection, _ = self.listener.accept()
            with connection:
                connection.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
                self.shake_hands(connection)
                self.follow(connection)
        except OSError:
            pass

    def shake_hands(self, connection):
        asked = b""
        while not asked.endswith(b"\r\n\r\n"):
            asked += received(connection, 1)
        lines = (line.split(b": ", 1) for line in asked.split(b"\r\n") if b": " in line)
        key = {name.lower(): value for name, value in lines}[b"sec-websocket-key"]
        accept = base64.b64encode(hashlib.sha1(key + GUID).digest())
        connection.sendall(
            b"HTTP/1.1 101 Switching Protocols\r\nUpgrade: websocket\r\nConnection: Upgrade\r\n"
            b"Sec-WebSocket-Accept: " + accept + b"\r\n\r\n"
        )

    def follow(self, connection):
        start = time.monotonic()
        while (now := self.cursor(time.monotonic() - start)) is not None:
            if isinstance(now, str):
                connection.sendall(frame(now.encode()))
                continue
            place, pressed = now
            connection.sendall(frame(json.dumps(self.state(place, pressed)).encode()))
            told = read_frame(connection)
            if told is None or told[0] == 8:
                return
            force = self.force(json.loads(told[1]))
            self.felt.append((time.monotonic() - start, place, pressed, force))

    def state(self, place, pressed):
        cursor = dict(zip("xyz", place))
        return {
            "inverse3": [
                {
                    "device_id": self.device_id,
                    "config": {"handedness": "right"},
                    "state": {"cursor_position": cursor, "cursor_velocity": {"x": 0, "y": 0, "z": 0}},
                }
            ],
            "wireless_verse_grip": [
                {"device_id": "4567", "state": {"buttons": {"a": pressed, "b": False, "c": False}}}
            ],
        }

    def force(self, message):
        (device,) = message["inverse3"]
        assert device["device_id"] == self.device_id
        values = device["commands"]["set_cursor_force"]["values"]
        return tuple(values[axis] for axis in "xyz")
