"""A way to a server that can be cut: for what happens to clients when connections break."""

import socket
import threading


class Relay:
    """Listens on a free port and passes bytes on to the port `target`, which may change.

    drop_answers: so many of the next connections are cut when the server has begun to answer. cut_after: connections are cut
    after so many bytes of answer.
    """

    def __init__(self, target):
        self.target, self.drop_answers, self.cut_after = target, 0, None
        self.connections = 0
        self.listening = socket.create_server(("127.0.0.1", 0))
        self.port = self.listening.getsockname()[1]
        threading.Thread(target=self._accept, daemon=True).start()

    def close(self):
        self.listening.close()

    def _accept(self):
        while True:
            try:
                client, _ = self.listening.accept()
            except OSError:
                return
            self.connections += 1
            threading.Thread(target=self._serve, args=(client,), daemon=True).start()

    def _serve(self, client):
        with client:
            try:
                server = socket.create_connection(("127.0.0.1", self.target))
            except OSError:
                return
            with server:
                threading.Thread(target=self._pass, args=(client, server), daemon=True).start()
                self._pass(server, client, answers=True)
                for end in (client, server):
                    try:
                        end.shutdown(socket.SHUT_RDWR)
                    except OSError:
                        pass

    def _pass(self, source, sink, answers=False):
        passed = 0
        try:
            while part := source.recv(4096):
                if answers and self.drop_answers > 0:
                    self.drop_answers -= 1
                    return
                passed += len(part)
                sink.sendall(part)
                if answers and self.cut_after is not None and passed >= self.cut_after:
                    return
        except OSError:
            pass
