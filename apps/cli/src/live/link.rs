//! The sockets: where packets come from, and where answers go.

use std::io::ErrorKind;
use std::net::{IpAddr, Ipv4Addr, Ipv6Addr, SocketAddr, ToSocketAddrs, UdpSocket};
use std::time::Duration;

use super::packet::{Refused, Why};
use crate::failure::{Failure, Kind};

/// Longest wait for a packet, after which the program looks whether it is to end.
const WAIT: Duration = Duration::from_millis(50);

/// Largest datagram [bytes].
pub const LARGEST: usize = 1 << 16;

/// A socket that packets come to. The first good packet decides whose packets are taken.
#[derive(Debug)]
pub struct Source {
    socket: UdpSocket,
    peer: Option<SocketAddr>,
}

impl Source {
    /// Listens at `place`: udp:PORT, on this machine alone; udp:HOST:PORT, on that address of this machine.
    pub fn open(place: &str) -> Result<Self, Failure> {
        const EXPECTED: &str = "udp:PORT or udp:HOST:PORT";
        let given = stripped("--from", place, EXPECTED)?;
        let alone = given.parse::<u16>().map(|port| SocketAddr::from((Ipv4Addr::LOCALHOST, port)));
        let address = alone.or_else(|_| resolved("--from", place, given, EXPECTED))?;
        let failed = |error| Failure::new(format!("--from {place}: cannot listen there: {error}"));
        let socket = UdpSocket::bind(address).map_err(failed)?;
        socket.set_read_timeout(Some(WAIT)).map_err(failed)?;
        Ok(Self { socket, peer: None })
    }

    /// Where it listens.
    pub fn place(&self) -> Result<SocketAddr, Failure> {
        self.socket.local_addr().map_err(|error| Failure::of_kind(Kind::Failed, error.to_string()))
    }

    /// The next datagram: its length and its sender; `None`: there is none yet.
    pub fn receive(&self, buffer: &mut [u8]) -> Result<Option<(usize, SocketAddr)>, Failure> {
        match self.socket.recv_from(buffer) {
            Ok(found) => Ok(Some(found)),
            Err(error) => match error.kind() {
                // Windows reports here that an earlier answer found no receiver.
                ErrorKind::ConnectionReset
                | ErrorKind::Interrupted
                | ErrorKind::TimedOut
                | ErrorKind::WouldBlock => Ok(None),
                _ => Err(Failure::of_kind(Kind::Failed, format!("packets cannot be received: {error}"))),
            },
        }
    }

    /// Whether packets of `sender` are taken.
    pub fn check(&self, sender: SocketAddr) -> Result<(), Refused> {
        match self.peer {
            Some(peer) if peer != sender => {
                let sentence = format!("{sender} sends too; the packets of {peer} are flown");
                Err(Refused::new(Why::Address, sentence))
            }
            _ => Ok(()),
        }
    }

    /// Takes the packets of `sender` from now on. Whether there was no sender before.
    pub fn hold(&mut self, sender: SocketAddr) -> bool {
        self.peer.replace(sender).is_none()
    }
}

/// Where answers go.
#[derive(Debug)]
pub struct Target {
    socket: UdpSocket,
    address: SocketAddr,
}

impl Target {
    pub fn open(place: &str) -> Result<Self, Failure> {
        const EXPECTED: &str = "udp:HOST:PORT";
        let given = stripped("--to", place, EXPECTED)?;
        let address = resolved("--to", place, given, EXPECTED)?;
        let any = match address.ip() {
            IpAddr::V4(_) => IpAddr::from(Ipv4Addr::UNSPECIFIED),
            IpAddr::V6(_) => IpAddr::from(Ipv6Addr::UNSPECIFIED),
        };
        let failed = |error| Failure::of_kind(Kind::Failed, format!("--to {place}: {error}"));
        let socket = UdpSocket::bind(SocketAddr::new(any, 0)).map_err(failed)?;
        Ok(Self { socket, address })
    }

    /// Sends a datagram. Whether it was sent: whether somebody receives it is not known.
    pub fn send(&self, datagram: &[u8]) -> bool {
        self.socket.send_to(datagram, self.address).is_ok()
    }
}

fn stripped<'a>(option: &str, place: &'a str, expected: &str) -> Result<&'a str, Failure> {
    place
        .strip_prefix("udp:")
        .ok_or_else(|| Failure::new(format!("{option} {place}: expected {expected}, for example udp:5500")))
}

fn resolved(option: &str, place: &str, given: &str, expected: &str) -> Result<SocketAddr, Failure> {
    let failed = |why: &str| {
        Failure::new(format!("{option} {place}: expected {expected}, with a port from 0 to 65535: {why}"))
    };
    let mut found = given.to_socket_addrs().map_err(|error| failed(&error.to_string()))?;
    found.next().ok_or_else(|| failed("no such host"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn places_are_read() {
        let source = Source::open("udp:0").unwrap();
        let place = source.place().unwrap();
        assert!(place.ip().is_loopback() && place.port() != 0);
        let target = Target::open(&format!("udp:{place}")).unwrap();
        assert!(target.send(b"abc"));
        let mut buffer = [0; 10];
        let (length, sender) = source.receive(&mut buffer).unwrap().unwrap();
        assert_eq!(
            (&buffer[..length], sender.port()),
            (&b"abc"[..], target.socket.local_addr().unwrap().port())
        );
        assert!(source.receive(&mut buffer).unwrap().is_none());
        for place in ["5500", "tcp:5500", "udp:", "udp:a", "udp:70000", "udp:127.0.0.1"] {
            let error = Source::open(place).unwrap_err().to_string();
            assert!(error.starts_with(&format!("--from {place}: expected udp:")), "{error}");
        }
        let taken = format!("udp:{place}");
        assert!(Source::open(&taken).unwrap_err().to_string().contains("cannot listen there"));
        assert!(Target::open("udp:5501").unwrap_err().to_string().contains("expected udp:HOST:PORT"));
    }

    #[test]
    fn one_sender_is_flown() {
        let mut source = Source::open("udp:0").unwrap();
        let [one, other] = [4000, 4001].map(|port| SocketAddr::from(([127, 0, 0, 1], port)));
        assert!(source.check(one).is_ok() && source.hold(one) && !source.hold(one));
        assert_eq!(source.check(other).unwrap_err().why, Why::Address);
        assert!(source.check(one).is_ok());
    }
}
