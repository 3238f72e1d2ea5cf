"""Checks of a running controller, one connection family a class.

    python3 tests/interop/test_controller.py 127.0.0.1 5002=PORT 5003=PORT 5004=PORT 5006=PORT

The controller runs the project in `tests/interop/machine`. Every check leaves it as it found it, but for the last ones: they
load an operating system and restart it.
"""

import socket
import struct
import sys
import time
import unittest

from acr import FastStatus, Management, Missing, Mixed, TIMEOUT, Text, crc32

HOST = "127.0.0.1"
PORTS = {}

# Of axis 0 (guide, axis parameters and flags).
TARGET, ACTUAL, PPU = 12289, 12290, 12375
CURRENT = 12288
JOG_ACTIVE = 792
# Of master 0.
MOVING = 516
# The inputs and outputs of the card.
INPUTS, OUTPUTS = 4096, 4097
SECOND_OUTPUT_FLAG = 33
# Kill all motion request of axis 0.
KILL_MOTION = 8467


def text():
    return Text(HOST, PORTS[5002])


def mixed():
    return Mixed(HOST, PORTS[5006])


def fast_status():
    return FastStatus(HOST, PORTS[5003])


def management():
    return Management(HOST, PORTS[5004])


def until(condition, what):
    """Waits for something that takes its time in the controller."""
    deadline = time.monotonic() + TIMEOUT
    while not condition():
        if time.monotonic() > deadline:
            raise AssertionError("waited in vain: " + what)
        time.sleep(0.002)


def connected(open_connection):
    """A connection that the controller serves. One that was closed just now may still hold its place."""
    deadline = time.monotonic() + TIMEOUT
    while True:
        try:
            connection = open_connection()
            connection.command("")
            return connection
        except (Missing, OSError, AssertionError):
            if time.monotonic() > deadline:
                raise
            time.sleep(0.01)


class TextCommands(unittest.TestCase):
    """Port 5002."""

    def test_a_command_without_a_report_answers_with_echo_and_prompt(self):
        with text() as client:
            self.assertEqual(client.command("PROG0"), ([], "P00>"))
            self.assertEqual(client.command("ACC 100 DEC 100"), ([], "P00>"))
            self.assertEqual(client.command("ACC"), (["100"], "P00>"))
            self.assertEqual(client.command("SYS"), ([], "SYS>"))

    def test_numbers_and_bits_are_bare(self):
        with text() as client:
            self.assertEqual(client.lines("?P%d" % PPU), ["1000"])
            self.assertEqual(client.lines("? P%d" % PPU), ["1000"])
            self.assertEqual(client.lines("PRINT(P%d/8)" % PPU), ["125"])
            self.assertEqual(client.lines("?BIT%d" % MOVING), ["0"])
            client.command("SET %d" % SECOND_OUTPUT_FLAG)
            self.assertEqual(client.lines("?BIT(%d)" % SECOND_OUTPUT_FLAG), ["-1"])
            client.command("CLR%d" % SECOND_OUTPUT_FLAG)
            self.assertEqual(client.lines("PRINT BIT %d" % SECOND_OUTPUT_FLAG), ["0"])

    def test_lines_end_with_return_or_return_and_line_feed(self):
        with text() as client:
            client.send(b"SYS\r\nSYS\r\r\n")
            expected = b"SYS\r\nSYS>SYS\r\nSYS>\r\nSYS>"
            self.assertEqual(client.take(len(expected)), expected)
            client.command("")

    def test_an_error_is_a_line(self):
        with text() as client:
            self.assertEqual(client.command("NOSUCHTHING"), (["Unknown Command"], "SYS>"))
            answer, prompt = client.command("VEL 10")
            self.assertEqual((len(answer), prompt), (1, "SYS>"))

    def test_level_and_echo_belong_to_a_connection(self):
        with text() as one, text() as two, mixed() as three:
            one.command("PROG0")
            three.command("PROG1")
            self.assertEqual(two.command(""), ([], "SYS>"))
            two.send(b"ECHO 4\r")
            self.assertEqual(two.take(8), b"ECHO 4\r\n")
            two.send(b"?1+1\r")
            self.assertEqual(two.take(3), b"2\r\n")
            self.assertEqual(one.command(""), ([], "P00>"))
            self.assertEqual(three.command(""), ([], "P01>"))

    def test_four_clients_are_served_and_a_fifth_when_one_leaves(self):
        clients = [connected(make) for make in (text, text, mixed, mixed)]
        try:
            with self.assertRaises((Missing, OSError, AssertionError)):
                with text() as fifth:
                    fifth.command("")
        finally:
            clients.pop().close()
        connected(text).close()
        for client in clients:
            client.close()

    def test_a_program_is_entered_listed_and_run(self):
        with text() as client:
            client.command("PROG2")
            client.command("NEW")
            for line in ("PROGRAM", 'PRINT "first"', "_again", 'PRINT "second"', "ENDP"):
                self.assertEqual(client.command(line), ([], "P02>"))
            self.assertIn('PRINT "first"', " ".join(client.lines("LIST")))
            client.send(b"LRUN\r")
            expected = b"LRUN\r\nfirst\r\nsecond\r\n"
            self.assertEqual(client.take(len(expected)), expected)
            client.send(b"\x1b")
            client.take_until_prompt()
            client.command("NEW")

    def test_control_characters_act_inside_a_line(self):
        with text() as client:
            client.command("PROG0")
            client.send(b"AXIS0 \x18PPU\r")
            until(lambda: b"P00>" in client.buffer or client.more(), "the prompt")
            client.buffer = b""
            self.assertEqual(client.lines("?BIT%d" % KILL_MOTION), ["-1"])
            client.send(b"\x19:AXIS0 PPU\r")
            until(lambda: client.buffer.endswith(b"P00>") or client.more(), "the prompt")
            self.assertIn(b"\r\n1000\r\n", client.buffer)
            client.buffer = b""
            self.assertEqual(client.lines("?BIT%d" % KILL_MOTION), ["0"])

    def test_a_move_answers_at_once(self):
        with text() as client:
            client.command("PROG0")
            client.command("DRIVE ON X")
            client.command("ACC 100 DEC 100 STP 100 VEL 20")
            client.command("RES X")
            client.command("X5")
            self.assertEqual(client.lines("?BIT(516)"), ["-1"])
            until(lambda: client.number("BIT(516)") == 0, "the end of the move")
            self.assertEqual(client.lines("?P%d" % CURRENT), ["5000"])


class BinaryPackets(unittest.TestCase):
    """Port 5006."""

    def test_text_and_binary_share_the_connection(self):
        with mixed() as client:
            client.command("PROG0")
            # The specification's example, with the group index of actual position that the guide has.
            client.send(bytes.fromhex("56 45 4C 32 32 0D 00 00 00 30 02 2C"))
            # Text is executed in its turn and packets are answered at once, so either may come first.
            head, text = bytes.fromhex("00 30 02 2C"), b"VEL22\r\nP00>"
            heard = client.take(len(text) + len(head) + 3 * 4)
            self.assertIn(head, heard)
            place = heard.index(head)
            self.assertEqual(heard[:place] + heard[place + 16 :], text)
            self.assertEqual(client.lines("VEL"), ["22"])
            client.command("VEL 10")

    def test_parameters_as_long_and_as_ieee(self):
        with mixed() as client:
            self.assertEqual(client.get_long(PPU), 1000)
            self.assertEqual(client.get_ieee(PPU), 1000.0)
            client.set_long(0, -123456)
            self.assertEqual(client.get_long(0), -123456)
            self.assertEqual(client.lines("?P0"), ["-123456"])
            client.set_ieee(1, 0.15625)
            self.assertEqual(client.get_ieee(1), 0.15625)
            self.assertEqual(client.lines("?P1"), ["0.15625"])

    def test_a_group_has_a_field_for_each_bit_of_the_mask(self):
        with mixed() as client:
            client.command("PROG0")
            fields = client.group(0x30, 0x02, 0xFF)
            self.assertEqual(len(fields), 8)
            (first,) = client.group(0x30, 0x02, 0x01)
            self.assertEqual(first, fields[0])
            self.assertEqual(struct.unpack("<i", first)[0], client.get_long(ACTUAL))
            flags = client.group(0x10, 0, 0x03)
            self.assertEqual(struct.unpack("<i", flags[0])[0], client.get_long(INPUTS))
            self.assertEqual(struct.unpack("<i", flags[1])[0], client.get_long(OUTPUTS))

    def test_requests_in_a_row_are_answered_in_their_order(self):
        with mixed() as client:
            requests = b"".join(struct.pack("<BBH", 0, 0x88, ACTUAL + 256 * (at % 4)) for at in range(400))
            client.send(requests)
            for at in range(400):
                self.assertEqual(client.take(8)[:4], requests[4 * at : 4 * at + 4])

    def test_bits(self):
        with mixed() as client:
            client.set_bit(SECOND_OUTPUT_FLAG)
            self.assertEqual(client.get_long(OUTPUTS) & 2, 2)
            client.clear_bit(SECOND_OUTPUT_FLAG)
            self.assertEqual(client.get_long(OUTPUTS) & 2, 0)

    def test_masks_of_a_parameter(self):
        with mixed() as client:
            client.parameter_mask(OUTPUTS, 0xFFFFFFFF, 0x00000005)
            self.assertEqual(client.get_long(OUTPUTS), 5)
            client.parameter_mask(OUTPUTS, 0x00000001, 0)
            self.assertEqual(client.get_long(OUTPUTS), 4)
            address = client.parameter_address(OUTPUTS)
            self.assertNotEqual(address, 0)
            client.mask(address, 0xFFFFFFFF, 0)
            self.assertEqual(client.get_long(OUTPUTS), 0)

    def test_memory_of_global_variables(self):
        with mixed() as client:
            address = client.parameter_address(10)
            self.assertNotEqual(address, 0)
            client.poke(address, [struct.pack("<f", 2.5), struct.pack("<f", -1.0)], conversion=1)
            self.assertEqual(client.get_ieee(10), 2.5)
            self.assertEqual(client.get_ieee(11), -1.0)
            words = client.peek(address, 2, conversion=1)
            self.assertEqual([struct.unpack("<f", word)[0] for word in words], [2.5, -1.0])

    def test_memory_of_local_variables(self):
        with mixed() as client:
            client.command("PROG1")
            client.command("LV0 = 77 : LV1 = -1 : SA0(2) = 0.5")
            longs = client.address(1, 4)
            words = client.peek(longs, 3)
            self.assertEqual([struct.unpack("<i", word)[0] for word in words], [2, 77, -1])
            arrays = client.address(1, 3)
            count, first = (struct.unpack("<I", word)[0] for word in client.peek(arrays, 2))
            self.assertEqual(count, 1)
            (size,) = client.peek(first, 1)
            self.assertEqual(struct.unpack("<i", size)[0], 4)

    def test_what_is_not_there_has_no_address(self):
        with mixed() as client:
            self.assertEqual(client.address(7, 0), 0)

    def test_overrides(self):
        with mixed() as client:
            client.command("PROG0")
            client.feedrate_override(0x01, 0.5)
            self.assertEqual(client.lines("FOV"), ["0.5"])
            client.feedrate_override(0x01, 1.0)
            client.rapid_override(0x01, 0.25)
            self.assertEqual(client.lines("ROV"), ["0.25"])
            client.rapid_override(0x01, 1.0)

    def test_a_binary_move(self):
        with mixed() as client:
            client.command("PROG0")
            client.command("DRIVE ON X Y")
            client.command("ACC 200 DEC 200 STP 200")
            client.command("RES X Y")
            client.move({0: 3.0, 1: -1.0}, velocity=50.0)
            until(lambda: client.get_long(CURRENT) == 3000, "the move of X")
            until(lambda: client.get_long(CURRENT + 256) == -1000, "the move of Y")
            client.move({0: 1.5}, incremental=True)
            until(lambda: client.get_long(CURRENT) == 4500, "the move of X")

    def test_a_transfer_that_stops_is_thrown_away(self):
        with mixed() as client:
            client.send(b"\x00\x89\x00\x00")
            # Longer than the 50 ms that a transfer may pause.
            time.sleep(0.2)
            client.command("SYS")
            self.assertEqual(client.get_long(PPU), 1000)


class FastStatusDatagrams(unittest.TestCase):
    """Port 5003."""

    def test_fields_are_those_of_fstat(self):
        with text() as client, fast_status() as status:
            client.command("FSTAT0(48,2)")
            client.command("FSTAT ON")
            status.subscribe(1, 10)
            fields = status.datagram()
            self.assertEqual(struct.unpack(">i", fields[0])[0], int(client.number("P%d" % ACTUAL)))

    def test_a_subscription_ends(self):
        with fast_status() as status:
            status.subscribe(1, 5)
            for _ in range(5):
                status.datagram()
            status.subscribe(0, 0)
            self.assertTrue(status.is_quiet(0.3))

    def test_five_clients(self):
        clients = [fast_status() for _ in range(5)]
        for status in clients:
            status.subscribe(1, 5)
        for status in clients:
            for _ in range(3):
                status.datagram()
        for status in clients:
            status.__exit__()


class ManagementPackets(unittest.TestCase):
    """Port 5004."""

    def test_the_configuration_file_has_a_crc(self):
        with management() as client:
            file, crc = client.configuration()
            self.assertEqual(len(file), 1020)
            self.assertEqual(crc, crc32(file))

    def test_a_watchdog_is_echoed_while_its_connections_live(self):
        with management() as client, text() as guarded:
            request = client.watchdog(60000, 3, guarded.port, 0)
            for _ in range(3):
                client.send(request)
                self.assertEqual(client.take(len(request)), request)
            client.send(client.watchdog(0, 0, guarded.port, 0))

    def test_a_watchdog_closes_what_it_guards(self):
        with management() as client, text() as guarded, text() as other:
            client.send(client.watchdog(50, 2, guarded.port, 0))
            self.assertTrue(guarded.is_closed())
            other.command("")

    def test_a_watchdog_ends_fast_status(self):
        with management() as client, fast_status() as status:
            status.subscribe(1, 5)
            status.datagram()
            client.send(client.watchdog(50, 2, 0, status.port))
            self.assertTrue(status.is_quiet(0.5))

    def test_a_watchdog_that_is_switched_off_guards_nothing(self):
        with management() as client, text() as guarded:
            client.send(client.watchdog(200, 1, guarded.port, 0))
            client.send(client.watchdog(0, 1, guarded.port, 0))
            time.sleep(0.6)
            guarded.command("")

    def test_five_sockets(self):
        clients = [management() for _ in range(5)]
        for client in clients:
            client.configuration()
        for client in clients:
            client.close()


class Restart(unittest.TestCase):
    """What closes every connection. Runs last."""

    def test_a_a_reboot(self):
        with text() as client, management() as manager:
            # Without it the settings are those of the factory again.
            client.command("ESAVE")
            client.command("PROG0")
            manager.reboot()
            self.assertTrue(client.is_closed())
            self.assertTrue(manager.is_closed())
        with connected(text) as client:
            self.assertEqual(client.command(""), ([], "SYS>"))

    def test_b_an_operating_system(self):
        blocks = [bytes((at * 7 + index) % 256 for at in range(1024)) for index in range(3)]
        whole = b"".join(blocks)
        right = whole[:-4] + struct.pack(">I", crc32(whole[:-4]))
        with management() as client, text() as other, management() as second:
            # The last block first, with a wrong CRC.
            for index in (2, 0, 1):
                client.block(index, blocks[index])
            self.assertEqual(client.end_download(), 1)
            self.assertTrue(other.is_closed())
            self.assertTrue(second.is_closed())
            client.block(2, right[2048:])
            self.assertEqual(client.end_download(), 0)
            client.reboot()
            self.assertTrue(client.is_closed())
        with connected(text) as client:
            self.assertEqual(client.lines("?P%d" % PPU), ["1000"])


def main():
    """Takes the address and the ports from the command line."""
    global HOST
    arguments = sys.argv[1:]
    HOST = socket.gethostbyname(arguments[0])
    for pair in arguments[1:]:
        name, _, port = pair.partition("=")
        PORTS[int(name)] = int(port)
    suite = unittest.TestSuite()
    for checks in (TextCommands, BinaryPackets, FastStatusDatagrams, ManagementPackets, Restart):
        suite.addTests(unittest.defaultTestLoader.loadTestsFromTestCase(checks))
    result = unittest.TextTestRunner(stream=sys.stdout, verbosity=2).run(suite)
    sys.exit(0 if result.wasSuccessful() else 1)


if __name__ == "__main__":
    main()
