"""A client of an ACR controller on the network, for Python 3.9 and later without further packages.

Written from the Ethernet specification of the ACR series and the chapter "Binary Host Interface" of the programmer's
guide, and from nothing else: it shares no code and no tables with the controller that it talks to. Where the two documents
leave something open, the comment says what is expected here.
"""

import re
import socket
import struct
import time

TIMEOUT = 20.0
"""Seconds after which an answer is taken to be missing. An answer that comes is never waited for that long."""

PROMPT = re.compile(rb"(?:^|\n)((?:SYS|P\d\d|PLC\d)>)$")


class Missing(Exception):
    """The controller did not answer, or closed the connection."""


class Connection:
    """A TCP connection with a buffer."""

    def __init__(self, host, port):
        self.socket = socket.create_connection((host, port), timeout=TIMEOUT)
        self.socket.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
        self.buffer = b""

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.close()

    @property
    def port(self):
        """The port of this end, by which a watchdog names the connection."""
        return self.socket.getsockname()[1]

    def close(self):
        """Ends the connection as the specification recommends: no more to send, read the rest, close."""
        try:
            self.socket.shutdown(socket.SHUT_WR)
            deadline = time.monotonic() + TIMEOUT
            while time.monotonic() < deadline and self.socket.recv(4096):
                pass
        except OSError:
            pass
        self.socket.close()

    def send(self, data):
        self.socket.sendall(data)

    def more(self):
        """Reads once into the buffer."""
        try:
            data = self.socket.recv(65536)
        except socket.timeout:
            raise Missing("nothing more after {!r}".format(self.buffer)) from None
        if not data:
            raise Missing("the controller closed the connection after {!r}".format(self.buffer))
        self.buffer += data

    def take(self, count):
        """Exactly so many bytes."""
        while len(self.buffer) < count:
            self.more()
        data, self.buffer = self.buffer[:count], self.buffer[count:]
        return data

    def take_until_prompt(self):
        """Everything up to a prompt with nothing behind it."""
        while not PROMPT.search(self.buffer):
            self.more()
        data, self.buffer = self.buffer, b""
        return data

    def is_closed(self):
        """Waits until the controller closes the connection; what it still sends is dropped."""
        try:
            while self.socket.recv(4096):
                pass
        except socket.timeout:
            return False
        except OSError:
            pass
        return True


class Text(Connection):
    """Port 5002: ASCII commands."""

    def pack(self, data):
        return data

    def command(self, line):
        """Sends a line and gives the lines of the answer, without echo and prompt, and the prompt."""
        self.send(self.pack(line.encode("latin-1") + b"\r"))
        answer = self.take_until_prompt().decode("latin-1")
        lines = answer.split("\r\n")
        if lines[0] != line:
            raise AssertionError("{!r} is not echoed in {!r}".format(line, answer))
        return lines[1:-1], lines[-1]

    def lines(self, line):
        """The lines of the answer alone."""
        return self.command(line)[0]

    def number(self, expression):
        """The value of an expression, as the terminal prints it."""
        (answer,) = self.lines("?" + expression)
        return float(answer)


class Mixed(Text):
    """Port 5006: ASCII in packets of four bytes, and binary packets between them."""

    def pack(self, data):
        return data + b"\0" * (-len(data) % 4)

    def ask(self, request, count):
        """Sends a request; its four bytes come first in the answer, then so many fields of four bytes."""
        self.send(self.pack(request))
        head = self.take(4)
        if head != request[:4]:
            raise AssertionError("{} answers {}".format(head.hex(" "), request.hex(" ")))
        return self.take(4 * count)

    def group(self, code, index, mask):
        """Parameters of a group: one field for each bit of the mask, as their bytes."""
        count = bin(mask).count("1")
        data = self.ask(bytes([0x00, code, index, mask]), count)
        return [data[at : at + 4] for at in range(0, len(data), 4)]

    def get_long(self, parameter):
        return struct.unpack("<i", self.ask(struct.pack("<BBH", 0x00, 0x88, parameter), 1))[0]

    def set_long(self, parameter, value):
        self.send(struct.pack("<BBHi", 0x00, 0x89, parameter, value))

    def get_ieee(self, parameter):
        return struct.unpack("<f", self.ask(struct.pack("<BBH", 0x00, 0x8A, parameter), 1))[0]

    def set_ieee(self, parameter, value):
        self.send(struct.pack("<BBHf", 0x00, 0x8B, parameter, value))

    def peek(self, address, count, conversion=0):
        """Words of memory; the address comes back in front of them."""
        request = struct.pack("<BBBBI", 0x00, 0x90, conversion, count, address)
        data = self.ask(request, 1 + count)
        if data[:4] != request[4:]:
            raise AssertionError("the address {} comes back as {}".format(request[4:].hex(" "), data[:4].hex(" ")))
        return [data[at : at + 4] for at in range(4, len(data), 4)]

    def poke(self, address, words, conversion=0):
        self.send(struct.pack("<BBBBI", 0x00, 0x91, conversion, len(words), address) + b"".join(words))

    def address(self, program, code):
        """Where the variables of a program are."""
        return struct.unpack("<I", self.ask(bytes([0x00, 0x92, program, code]), 1))[0]

    def parameter_address(self, parameter):
        return struct.unpack("<I", self.ask(struct.pack("<BBH", 0x00, 0x93, parameter), 1))[0]

    def mask(self, address, nand, bits):
        self.send(struct.pack("<BBBBIII", 0x00, 0x94, 0, 0, address, nand, bits))

    def parameter_mask(self, parameter, nand, bits):
        self.send(struct.pack("<BBHII", 0x00, 0x95, parameter, nand, bits))

    def set_bit(self, bit):
        self.send(struct.pack("<BHB", 0x1C, bit, 0))

    def clear_bit(self, bit):
        self.send(struct.pack("<BHB", 0x1D, bit, 0))

    def feedrate_override(self, masters, value):
        self.send(struct.pack("<BBBBf", 0x07, masters, 0, 0, value))

    def rapid_override(self, masters, value):
        self.send(struct.pack("<BBBBf", 0x1F, masters, 0, 0, value))

    def move(self, targets, velocity=None, incremental=False):
        """A linear move of master 0; targets are floating point, by number of slave (0 to 7)."""
        code0 = 0x08 | (0x10 if velocity is not None else 0)
        code2 = sum(1 << slave for slave in targets)
        code3 = 0x04 | (0x01 if incremental else 0)
        data = bytes([0x04, code0, 0, code2, code3])
        if velocity is not None:
            data += struct.pack("<f", velocity)
        for slave in sorted(targets):
            data += struct.pack("<f", targets[slave])
        # The documents do not say where the zeros go that fill up a header of five bytes; they are expected at the end.
        self.send(self.pack(data))


class FastStatus:
    """Port 5003: datagrams of 80 fields."""

    def __init__(self, host, port):
        self.controller = (host, port)
        self.socket = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        self.socket.bind((host, 0))
        self.socket.settimeout(TIMEOUT)

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.subscribe(0, 0)
        self.socket.close()

    @property
    def port(self):
        return self.socket.getsockname()[1]

    def subscribe(self, mode, interval):
        self.socket.sendto(struct.pack(">II", mode, interval), self.controller)

    def datagram(self):
        """The next one, as its 80 fields."""
        try:
            data, sender = self.socket.recvfrom(2048)
        except socket.timeout:
            raise Missing("no fast status") from None
        if sender != self.controller:
            raise AssertionError("fast status from {}".format(sender))
        if len(data) != 320:
            raise AssertionError("a datagram of {} bytes".format(len(data)))
        return [data[at : at + 4] for at in range(0, 320, 4)]

    def is_quiet(self, seconds):
        """Whether nothing comes for so long, once what was under way has come."""
        self.socket.settimeout(seconds)
        deadline = time.monotonic() + TIMEOUT
        try:
            while time.monotonic() < deadline:
                self.socket.recvfrom(2048)
            return False
        except socket.timeout:
            return True
        finally:
            self.socket.settimeout(TIMEOUT)


class Management(Connection):
    """Port 5004: watchdog, alarms, configuration file, operating system, reboot."""

    WATCHDOG, USER, CONTROLLER, CONFIGURATION, BLOCK, END, REBOOT = range(1, 8)

    def watchdog(self, timer, ticker, command_port, fast_status_port):
        """The request of a watchdog that guards these ports of this client; timer in milliseconds."""
        address = socket.inet_aton(self.socket.getsockname()[0])
        return struct.pack(">III4sII", self.WATCHDOG, timer, ticker, address, command_port, fast_status_port)

    def subscribe(self, kind, filter_bits):
        self.send(struct.pack(">II", kind, filter_bits))

    def user_alarm(self):
        return struct.unpack(">II", self.take(8))

    def controller_alarm(self):
        return struct.unpack(">IIII", self.take(16))

    def configuration(self):
        """The 1020 bytes of the configuration file, and its CRC."""
        self.send(struct.pack(">I", self.CONFIGURATION))
        packet = self.take(4 + 1024)
        (kind,) = struct.unpack(">I", packet[:4])
        if kind != self.CONFIGURATION:
            raise AssertionError("a packet of kind {}".format(kind))
        return packet[4:1024], struct.unpack(">I", packet[1024:])[0]

    def block(self, index, data):
        self.send(struct.pack(">II", self.BLOCK, index) + data)

    def end_download(self):
        """Ends a download; the result is 0 for success, 1 for a wrong CRC, 2 for a failure of the memory."""
        self.send(struct.pack(">I", self.END))
        kind, result = struct.unpack(">II", self.take(8))
        if kind != self.END:
            raise AssertionError("a packet of kind {}".format(kind))
        return result

    def reboot(self):
        self.send(struct.pack(">I", self.REBOOT))


def crc32(data):
    """The CRC of Ethernet, from its polynomial, bit by bit."""
    remainder = 0xFFFFFFFF
    for byte in data:
        for bit in range(8):
            high = remainder >> 31 ^ (byte >> bit & 1)
            remainder = (remainder << 1 & 0xFFFFFFFF) ^ (0x04C11DB7 if high else 0)
    return int("{:032b}".format(remainder)[::-1], 2) ^ 0xFFFFFFFF
