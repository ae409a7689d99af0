//! `sins live`: packets by UDP from a peer in this process. Packets carry their time, so an hour takes seconds.

use std::io::{BufRead, BufReader};
use std::net::UdpSocket;
use std::path::{Path, PathBuf};
use std::process::{Child, Stdio};
use std::sync::mpsc::{Receiver, channel};
use std::time::{Duration, Instant};

use sins::records::line;
use sins::scene::builtin;
use sins::truth::FlightSample;
use sins::units::DEG;

use crate::draws::Draws;
use crate::support::{done, folder, number, read, rejected, rows, run, sins};

/// Packets on their way: a receive buffer of Linux holds some 160 of them.
const WINDOW: usize = 24;

/// Packets of a pause. They have no answer to wait for.
const PAUSE: u64 = 100;

/// A flight simulator, with the program that listens to it.
struct Peer {
    folder: PathBuf,
    program: Child,
    output: Receiver<String>,
    socket: UdpSocket,
    port: u16,
}

impl Peer {
    /// Starts the program with answers to the peer.
    fn start(folder: &Path, arguments: &[&str]) -> Self {
        let socket = UdpSocket::bind("127.0.0.1:0").unwrap();
        socket.set_read_timeout(Some(Duration::from_secs(20))).unwrap();
        let to = format!("udp:{}", socket.local_addr().unwrap());
        let fixed = ["live", "--from", "udp:0", "--to", &to, "--silence-s", "1"];
        let mut command = sins(folder, &[&fixed, arguments].concat());
        let mut program = command.stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().unwrap();
        let (sender, output) = channel();
        let lines = BufReader::new(program.stdout.take().unwrap()).lines();
        std::thread::spawn(move || lines.map_while(Result::ok).try_for_each(|line| sender.send(line)));
        let first = output.recv_timeout(Duration::from_secs(20)).unwrap();
        let place = first.strip_prefix("listening at udp:127.0.0.1:").expect(&first);
        let port = place.split(' ').next().unwrap().parse().unwrap();
        Self { folder: folder.to_owned(), program, output, socket, port }
    }

    fn send(&self, packet: &[u8]) {
        self.socket.send_to(packet, ("127.0.0.1", self.port)).unwrap();
    }

    /// The next answer.
    fn answer(&self) -> Vec<u8> {
        let mut buffer = [0; 2000];
        let length = self.socket.recv(&mut buffer).expect("an answer");
        buffer[..length].to_vec()
    }

    /// Waits for the end; exit code, standard output and standard error.
    fn end(self) -> (i32, String, String) {
        let lines: Vec<String> = self.output.iter().collect();
        let output = self.program.wait_with_output().unwrap();
        let errors = String::from_utf8(output.stderr).unwrap();
        (output.status.code().unwrap_or(-1), lines.join("\n"), errors)
    }

    /// The same for a run that succeeds.
    fn finish(self) -> (PathBuf, String) {
        let folder = self.folder.clone();
        let (code, said, errors) = self.end();
        assert_eq!(code, 0, "{said}\n{errors}");
        (folder, said)
    }
}

/// The flight of a built-in scene at a time [s].
fn at(scene: &str) -> impl Fn(f64) -> FlightSample {
    let flight = builtin(scene).unwrap().flight().unwrap();
    move |time_s| flight.sample_at(time_s).unwrap()
}

/// The packet of format generic, with all digits.
fn generic(sample: &FlightSample) -> Vec<u8> {
    let (place, v_n, euler) = (&sample.place, sample.v_n.unwrap(), &sample.euler);
    let degrees = |angle: f64| angle / DEG;
    line([
        sample.time_s,
        degrees(place.latitude_rad),
        degrees(place.longitude_rad),
        place.height_m,
        v_n.x,
        v_n.y,
        v_n.z,
        degrees(euler.roll),
        degrees(euler.pitch),
        degrees(euler.heading),
    ])
    .into_bytes()
}

/// The packet of format json, with `more` members.
fn json(sample: &FlightSample, more: &str) -> Vec<u8> {
    let text = String::from_utf8(generic(sample)).unwrap();
    let keys = "time_s,latitude_deg,longitude_deg,height_m,velocity_east_m_s,velocity_north_m_s,velocity_up_m_s,roll_deg,\
        pitch_deg,heading_deg";
    let members = keys.split(',').zip(text.split(',')).map(|(key, value)| format!("\"{key}\":{value}"));
    format!("{{{}{more}}}", members.collect::<Vec<_>>().join(",")).into_bytes()
}

/// FlightGear's packet, from the layout of its header, not from the program.
fn fgfs(sample: &FlightSample) -> Vec<u8> {
    let (place, v_n, euler) = (&sample.place, sample.v_n.unwrap(), &sample.euler);
    let mut packet = 24_u32.to_be_bytes().to_vec();
    packet.extend([0; 4]);
    for value in [place.longitude_rad, place.latitude_rad, place.height_m] {
        packet.extend(value.to_be_bytes());
    }
    let feet = |m: f64| (m / 0.3048) as f32;
    let angles = [0.0, euler.roll as f32, euler.pitch as f32, euler.heading as f32, 0.0, 0.0];
    let rates = [0.0; 5];
    let velocities = [feet(v_n.y), feet(v_n.x), feet(-v_n.z)];
    for value in angles.iter().chain(&rates).chain(&velocities) {
        packet.extend(value.to_be_bytes());
    }
    packet.resize(408, 0);
    packet
}

/// Asserts that the scene of a recorded log flies it to the same records and states.
fn assert_replayed(folder: &Path, live: &str, log: &str) {
    // Lost packets are gaps of the log.
    let (code, _, errors) = run(folder, &["fly", &format!("sins_out/{log}.toml"), "-q"]);
    assert!(code == 0 && errors.lines().all(|line| line.contains(": note: ")), "{errors}");
    for ending in [".csv", "_unit.csv"] {
        let [flown, replayed] =
            [live, &format!("{log}_replay")].map(|name| folder.join(format!("sins_out/{name}{ending}")));
        assert_eq!(flown.exists(), replayed.exists());
        if flown.exists() {
            let rows = read(&flown).lines().count();
            assert!(rows > 2 && read(&flown) == read(&replayed), "{live}{ending}: {rows} rows");
            println!("{live}{ending}: {rows} rows, the same in the replay");
        }
    }
}

/// The value of a figure in the summary of a run.
fn figure(folder: &Path, run: &str, key: &str) -> f64 {
    let summary = rows(&folder.join(format!("sins_out/{run}_summary.csv")));
    number(summary.iter().find(|row| row["key"] == key).unwrap(), "value")
}

/// Length of the closure of the position [m].
fn closure_m(folder: &Path, run: &str) -> f64 {
    let axis = |axis| figure(folder, run, &format!("closure_position_{axis}_m"));
    (axis("east").powi(2) + axis("north").powi(2) + axis("up").powi(2)).sqrt()
}

/// Numbers of the end of a run, by the words behind them.
fn counted(said: &str, words: &str) -> u64 {
    let end = said.rfind(&format!(" {words}")).unwrap_or_else(|| panic!("{words}: {said}"));
    said[..end].rsplit([' ', ',']).next().unwrap().parse().unwrap()
}

/// The ticks of a flight at 60 Hz in the order of their arrival, with 20 ms of jitter and 5 % of losses.
fn arrivals(ticks: u32) -> Vec<u32> {
    let mut draws = Draws::new(1);
    let arrivals = (0..ticks).filter_map(|tick| {
        let is_lost = draws.unit() < 0.05;
        let arrival_s = f64::from(tick) / 60.0 + 0.02 * draws.unit();
        (!is_lost || tick == 0).then_some((arrival_s, tick))
    });
    let mut arrivals: Vec<(f64, u32)> = arrivals.collect();
    arrivals.sort_by(|one, other| one.0.total_cmp(&other.0));
    arrivals.into_iter().map(|(_, tick)| tick).collect()
}

/// Sends the packets of ticks. Returns how many come before each later one, and the last of them.
fn send_all(peer: &Peer, packet: impl Fn(u32) -> Vec<u8>, ticks: &[u32]) -> (u64, u32) {
    let (mut newest, mut passed, mut answered) = (0, 0, 0);
    for (place, tick) in ticks.iter().enumerate() {
        peer.send(&packet(*tick));
        if place == 0 || *tick > newest {
            (newest, passed) = (*tick, passed + 1);
        }
        // The first sample has no answer.
        while passed > answered + WINDOW + 1 {
            peer.answer();
            answered += 1;
        }
    }
    (passed as u64, newest)
}

/// Resident memory of a program [KiB].
#[cfg(target_os = "linux")]
fn memory_kib(program: &Child) -> u64 {
    let status = read(format!("/proc/{}/status", program.id()));
    let line = status.lines().find_map(|line| line.strip_prefix("VmRSS:")).unwrap();
    line.trim().split(' ').next().unwrap().parse().unwrap()
}

/// Flies the patrol at 60 Hz with 20 ms of jitter, which exchanges packets, and 5 % of losses. Every packet that is not late is flown,
/// the losses are found, and the replay has the same bits.
///
/// Evidence for the bounds of the closure:
/// - the velocity in an interval h is a cubic polynomial, whose error is below v⁗ h⁴/384. For an aircraft that banks within a second,
///   v⁗ is below 10 m/s⁵: 1.3e-6 m/s in five periods, here taken for the whole flight;
/// - a velocity in single precision is rounded by up to half a unit in the last place, 3e-5 ft/s at 200 m/s. The sum over n
///   intervals is normal, with a sigma of h ulp √(n/12).
///
/// Returns its closure with the bound, in words.
fn fly_the_patrol(format: &str, ticks: u32) -> String {
    let truth = at("patrol");
    let sample = |tick: u32| truth(f64::from(tick) / 60.0);
    let folder = folder(&format!("jitter_{format}_{ticks}"));
    // The log of two days does not fit into the memory of a small machine.
    let record: &[&str] = if ticks > 1_000_000 { &[] } else { &["--record", "log.csv"] };
    let ticks = arrivals(ticks);
    let is_fgfs = format == "fgfs";
    let rate: &[&str] = if is_fgfs { &["--rate-hz", "60"] } else { &[] };
    let peer = Peer::start(&folder, &[&["--format", format], record, rate].concat());
    let packet = |tick| if is_fgfs { fgfs(&sample(tick)) } else { generic(&sample(tick)) };
    let began = Instant::now();
    #[cfg(target_os = "linux")]
    let before_kib = {
        peer.send(&packet(0));
        memory_kib(&peer.program)
    };
    let (passed, newest) = send_all(&peer, packet, &ticks);
    #[cfg(target_os = "linux")]
    {
        let grown_kib = memory_kib(&peer.program).saturating_sub(before_kib);
        println!("{format}: memory grew by {grown_kib} KiB");
        assert!(grown_kib < 4096, "{grown_kib} KiB");
    }
    let (folder, said) = peer.finish();
    let seconds = began.elapsed().as_secs_f64();
    assert_eq!(counted(&said, "flown, "), passed, "{said}");
    assert_eq!(counted(&said, "lost,"), u64::from(newest) + 1 - passed);
    let duration_s = figure(&folder, "live", "duration_s");
    assert!((duration_s - f64::from(newest) / 60.0).abs() < 1e-9 * duration_s, "{duration_s}");
    let closure = closure_m(&folder, "live");
    let of_float = 0.3048 * 6e-5 / 60.0 * (passed as f64 / 12.0).sqrt();
    let bound = 1.3e-6 * duration_s + if is_fgfs { 5.0 * of_float } else { 0.0 };
    println!("{format}: {duration_s:.0} s in {seconds:.1} s, {passed} flown");
    println!("{}", &said[said.find("  packets").unwrap()..]);
    assert!(closure < bound, "{closure} {bound}");
    if !record.is_empty() {
        assert_replayed(&folder, "live", "log");
    }
    format!("{closure:.1e} m (limit {bound:.1e} m) by {format} in {duration_s:.0} s")
}

#[test]
fn jitter_and_losses_do_no_harm() {
    let ticks = if cfg!(feature = "long-tests") { 216_000 } else { 18_000 };
    let closures = ["generic", "fgfs"].map(|format| fly_the_patrol(format, ticks)).join(", ");
    println!("figure: refused: the late ones alone; the replay has the same bytes; closure {closures}");
}

/// Takes a quarter of an hour.
#[test]
#[cfg(feature = "long-tests")]
fn two_days_need_no_more_memory() {
    fly_the_patrol("fgfs", 60 * 48 * 3600);
}

/// Packets that are no samples, and those of others, are counted by their reason, and the flight is that without them.
#[test]
fn wrong_packets_are_counted_and_never_flown() {
    let truth = at("aerobatics");
    let stranger = UdpSocket::bind("127.0.0.1:0").unwrap();
    let flown = |name: &str, are_sent: bool| {
        let folder = folder(name);
        let settings = ["--format", "fgfs", "--rate-hz", "50", "--preset", "tactical"];
        let peer = Peer::start(&folder, &settings);
        // Nothing that is wrong decides whose packets are flown.
        if are_sent {
            stranger.send_to(b"hello", ("127.0.0.1", peer.port)).unwrap();
        }
        for tick in 0..500 {
            let good = fgfs(&truth(f64::from(tick) / 50.0));
            let with = |at: usize, bytes: &[u8]| {
                let mut packet = good.clone();
                packet[at..at + bytes.len()].copy_from_slice(bytes);
                packet
            };
            peer.send(&good);
            if tick > 0 {
                peer.answer();
            }
            if are_sent && tick % 50 == 25 {
                stranger
                    .send_to(&fgfs(&truth(0.5 + f64::from(tick) / 50.0)), ("127.0.0.1", peer.port))
                    .unwrap();
                peer.send(&good[..407]);
                peer.send(&[]);
                peer.send(&with(0, &23_u32.to_be_bytes()));
                peer.send(&with(16, &f64::NAN.to_be_bytes()));
                peer.send(&with(76, &f32::INFINITY.to_be_bytes()));
                peer.send(&with(16, &2.0_f64.to_be_bytes()));
                peer.send(&with(24, &9e6_f64.to_be_bytes()));
                peer.send(&with(8, &1.0_f64.to_be_bytes()));
                peer.send(&fgfs(&truth(f64::from(tick - 3) / 50.0)));
            }
        }
        let (code, said, errors) = peer.end();
        assert_eq!(code, 0, "{errors}");
        (read(folder.join("sins_out/live.csv")), said, errors)
    };
    let (clean, _, _) = flown("clean", false);
    let (records, said, errors) = flown("wrong", true);
    assert!(records == clean && records.lines().count() > 10);
    let refused = "refused         10 from another address, 11 of another length, 20 of another kind, \
                   20 with NaN or infinity, 20 out of range, 10 late or repeated, 10 with a jump";
    assert!(said.contains(refused), "{said}");
    for words in [
        "of another length: 5 bytes: version 24 has 408",
        "of another kind: 407 bytes: FlightGear's native FDM packet, of another version or length, version 24; versions 24 with 408 bytes",
        "with NaN or infinity: latitude = NaN: must be a finite number",
        "out of range: latitude = 114.591559026165 deg: must be from -90 to 90 deg",
        "from another address: 127.0.0.1:",
        "with a jump: a way of ",
        "late or repeated: 3 periods before",
    ] {
        assert!(errors.contains(words), "{words}: {errors}");
    }
    assert_eq!(errors.matches("first packet").count(), 7, "{errors}");
}

/// A pause in which the clock runs on is left out, and a new place begins a flight with files of its own.
#[test]
fn pauses_are_left_out_and_jumps_begin_a_flight() {
    let truth = at("aerobatics");
    let folder = folder("pause");
    let arguments = ["--format", "json", "--preset", "tactical", "--record", "log.csv"];
    let peer = Peer::start(&folder, &[&arguments[..], &["--set", "output.every_s=0.5"]].concat());
    let send = |sample: &FlightSample, time_s: f64| {
        let fields = String::from_utf8(generic(&FlightSample { time_s, ..*sample })).unwrap();
        let names = [
            "time_s",
            "latitude_deg",
            "longitude_deg",
            "height_m",
            "velocity_east_m_s",
            "velocity_north_m_s",
            "velocity_up_m_s",
            "roll_deg",
            "pitch_deg",
            "heading_deg",
        ];
        let members: Vec<String> =
            names.iter().zip(fields.split(',')).map(|(name, value)| format!("\"{name}\": {value}")).collect();
        peer.send(format!("{{{}}}", members.join(", ")).as_bytes());
    };
    let mut clock_s = 1000.0;
    for tick in 0..1000 {
        clock_s += 0.02;
        let sample = truth(f64::from(tick) * 0.02);
        send(&sample, clock_s);
        if tick > 0 {
            peer.answer();
        }
        if tick == 400 {
            for _ in 0..PAUSE {
                clock_s += 0.02;
                send(&sample, clock_s);
            }
        }
    }
    // The user loads a flight elsewhere: the first two packets are not believed.
    for tick in 0..502 {
        let mut sample = truth(f64::from(tick) * 0.02);
        sample.place.longitude_rad += 0.5;
        clock_s += 0.02;
        send(&sample, clock_s);
        if tick > 2 {
            peer.answer();
        }
    }
    let (folder, said) = peer.finish();
    assert_eq!(counted(&said, "in pauses"), PAUSE, "{said}");
    assert!(said.contains("2 with a jump") && said.contains("another flight begins"), "{said}");
    let duration_s = |run| figure(&folder, run, "duration_s");
    assert!((duration_s("live") - 19.98).abs() < 1e-9 && (duration_s("live_2") - 9.98).abs() < 1e-9);
    assert_replayed(&folder, "live", "log");
    assert_replayed(&folder, "live_2", "log_2");
    // With perfect sensors the same flight closes: the pause was no motion.
    let page = read(folder.join("sins_out/live.html"));
    assert!(page.contains("Inertial navigation: 2 runs"));
}

/// What the INS believes comes back in each format. With ideal sensors it is the truth.
#[test]
fn answers_are_what_the_ins_believes() {
    let truth = at("aerobatics");
    let last_of = |send: &str, settings: &[&str]| {
        let folder = folder(&format!("answers_{send}"));
        let arguments = ["--format", "fgfs", "--rate-hz", "20", "--send", send];
        let peer = Peer::start(&folder, &[&arguments[..], settings].concat());
        let mut received = Vec::new();
        for tick in 0..=200 {
            let mut packet = fgfs(&truth(f64::from(tick) / 20.0));
            // The gear and the surfaces of the aircraft.
            packet[356..].fill(42);
            peer.send(&packet);
            let has_answer = match send {
                "nmea" => tick == 1 || tick % 4 == 0,
                _ => true,
            };
            if tick > 0 && has_answer {
                received.push(peer.answer());
            }
        }
        // The words of an interval may fill several datagrams.
        let mut buffer = [0; 2000];
        peer.socket.set_read_timeout(Some(Duration::from_millis(500))).unwrap();
        while let Ok(length) = peer.socket.recv(&mut buffer) {
            received.push(buffer[..length].to_vec());
        }
        let (_, said) = peer.finish();
        assert_eq!(counted(&said, "sent, 0 not sent"), received.len() as u64, "{said}");
        received
    };
    let expected = truth(10.0);
    let packets = last_of("fgfs", &[]);
    let packet = packets.last().unwrap();
    let double = |at: usize| f64::from_be_bytes(packet[at..at + 8].try_into().unwrap());
    let float = |at: usize| f64::from(f32::from_be_bytes(packet[at..at + 4].try_into().unwrap()));
    assert_eq!((packet.len(), &packet[..4], &packet[356..]), (408, &[0, 0, 0, 24][..], &[42; 52][..]));
    let (place, v_n) = (expected.place, expected.v_n.unwrap());
    assert!((double(8) - place.longitude_rad).abs() < 1e-9 && (double(16) - place.latitude_rad).abs() < 1e-9);
    assert!((double(24) - place.height_m).abs() < 0.01);
    for (at, value) in [(76, v_n.y), (80, v_n.x), (84, -v_n.z)] {
        assert!((float(at) * 0.3048 - value).abs() < 1e-3, "{at}: {} {value}", float(at));
    }
    let speed = [88, 92, 96].map(|at| float(at) * 0.3048).iter().map(|v| v * v).sum::<f64>().sqrt();
    assert!((speed - v_n.norm()).abs() < 1e-3);

    let objects = last_of("json", &[]);
    let object = String::from_utf8(objects.last().unwrap().clone()).unwrap();
    let value = |key: &str| -> f64 {
        let (_, after) = object.split_once(&format!("\"{key}\":")).unwrap();
        after.split([',', '}']).next().unwrap().parse().unwrap()
    };
    assert_eq!((objects.len(), value("time_s")), (200, 10.0));
    assert!((value("latitude_deg") * DEG - place.latitude_rad).abs() < 1e-9);
    assert!(object.ends_with(",\"state\":\"navigation\"}\n"), "{object}");

    let sentences = last_of("nmea", &[]);
    let text = String::from_utf8(sentences.last().unwrap().clone()).unwrap();
    assert!(text.starts_with("$INGGA,000010.00,") && text.contains("\r\n$INRMC,000010.00,A,"), "{text}");
    let degrees: Vec<&str> = text.split(',').collect();
    let latitude = degrees[2][..2].parse::<f64>().unwrap() + degrees[2][2..].parse::<f64>().unwrap() / 60.0;
    assert!((latitude - place.latitude_rad / DEG).abs() < 1e-6 && degrees[3] == "N", "{text}");

    let words = last_of("bus", &["--set", "unit.start=nav"]);
    let text = String::from_utf8(words.concat()).unwrap();
    let latitudes: Vec<&str> = text.lines().filter(|line| line.contains(",310,")).collect();
    assert_eq!(latitudes.len(), 100, "one each 0.1 s");
    let fields: Vec<&str> = latitudes.last().unwrap().split(',').collect();
    let [time_s, latitude] = [0, 3].map(|field| fields[field].parse::<f64>().unwrap());
    assert!((time_s - 10.0).abs() < 1e-6 && fields[5] == "normal", "{fields:?}");
    assert!((latitude - place.latitude_rad / DEG).abs() < 180.0 / f64::from(1 << 20), "{fields:?}");

    let of_lines = text.lines().map(|line| line.split(',').nth(2).unwrap().to_owned());
    let raw = last_of("words", &["--set", "unit.start=nav"]).concat();
    let raw = raw.chunks(4).map(|word| format!("{:08x}", u32::from_be_bytes(word.try_into().unwrap())));
    assert!(raw.eq(of_lines));
}

/// A unit aligns on live packets at rest; its states are a file, and the replay has the same.
#[test]
fn a_unit_aligns_live() {
    let folder = folder("unit");
    let scene = "[flight]\nfile = 'live'\n[gyro]\npreset = 'navigation'\n[accelerometer]\npreset = 'navigation'\n[unit]\nstart = 'off'\n\
        alignment_s = 60\n[[panel]]\nkind = 'nav'\nat_s = 5\n[[panel]]\nkind = 'true_position'\nat_s = 20\n\
        [[update]]\nkind = 'position'\nat_s = 90\nsigma_m = 10\n";
    std::fs::write(folder.join("box.toml"), scene).unwrap();
    let arguments = ["box.toml", "--format", "fgfs", "--rate-hz", "20", "--record", "log.csv"];
    let peer = Peer::start(&folder, &[&arguments[..], &["--seconds", "120"]].concat());
    let rest = FlightSample::at_rest(0.0, at("aerobatics")(0.0).place, sins::math::Euler::default());
    let mut answers = Vec::new();
    for tick in 0..=2400 {
        peer.send(&fgfs(&rest));
        if tick > 0 {
            answers.push(String::from_utf8(peer.answer()).unwrap());
        }
    }
    let (folder, said) = peer.finish();
    assert!(answers[0].contains("\"latitude_deg\":null") && answers[0].contains("\"state\":\"off\""));
    assert!(answers[2399].contains("\"state\":\"navigation\"") && !answers[2399].contains("null"));
    assert!(
        said.contains("fine alignment, 20 s to go; no position") && said.contains("120 s  navigation"),
        "{said}"
    );
    assert_replayed(&folder, "box_live", "log");
}

/// What a session writes.
fn files_of(folder: &Path, number: &str) -> Vec<String> {
    let endings = ["live#.csv", "live#_summary.csv", "log#.csv", "log#.toml"];
    endings.map(|name| read(folder.join("sins_out").join(name.replace('#', number)))).to_vec()
}

/// Sends the beginning of the patrol and waits for the answers.
fn send_patrol(peer: &Peer, ticks: u32) {
    let truth = at("patrol");
    for tick in 0..ticks {
        peer.send(&generic(&truth(f64::from(tick) * 0.1)));
        if tick > 0 {
            peer.answer();
        }
    }
}

/// No file of a session takes the place of a file of another one, whether it runs before or at the same time.
#[test]
fn sessions_do_not_replace_each_other() {
    let folder = folder("sessions");
    let arguments = ["--format", "generic", "--record", "log.csv"];
    let first = Peer::start(&folder, &arguments);
    let second = Peer::start(&folder, &arguments);
    send_patrol(&first, 20);
    // The log has its name from the first interval on: whatever ends a session, the log stays.
    assert!(folder.join("sins_out/log.toml").exists() && folder.join("sins_out/log.csv").exists());
    first.finish();
    let of_first = files_of(&folder, "");
    send_patrol(&second, 30);
    let (_, said) = second.finish();
    assert!(said.contains("sins_out/live_2.html"), "{said}");
    let of_second = files_of(&folder, "_2");
    let third = Peer::start(&folder, &arguments);
    send_patrol(&third, 40);
    let (_, _, errors) = third.end();
    assert!(errors.contains("there are files of earlier flights; this one is live_3"), "{errors}");
    assert!(files_of(&folder, "") == of_first && files_of(&folder, "_2") == of_second);
    assert_eq!(read(folder.join("sins_out/log_3.csv")).lines().count(), 2 + 40);
    for (live, log) in [("live", "log"), ("live_2", "log_2"), ("live_3", "log_3")] {
        assert!(folder.join(format!("sins_out/{live}.html")).exists());
        assert_replayed(&folder, live, log);
    }
    // With --force, the first names are taken again.
    let forced = Peer::start(&folder, &[&arguments[..], &["--force"]].concat());
    send_patrol(&forced, 50);
    forced.finish();
    assert_eq!(read(folder.join("sins_out/log.csv")).lines().count(), 2 + 50);
    assert!(files_of(&folder, "_2") == of_second);
}

/// A session that is killed leaves its log and the scene that flies it.
#[test]
fn the_log_of_a_killed_session_stays() {
    let folder = folder("killed");
    let mut peer = Peer::start(&folder, &["--format", "generic", "--record", "log.csv"]);
    send_patrol(&peer, 51);
    peer.program.kill().unwrap();
    peer.program.wait().unwrap();
    // The lines of a second are written together.
    assert!(read(folder.join("sins_out/log.csv")).lines().count() > 2 + 40);
    // Linux may end a write at a page of memory when the program is killed.
    let (code, _, errors) = run(&folder, &["fly", "sins_out/log.toml", "-q"]);
    let is_cut =
        errors.ends_with(": note: the last line is cut off, and left out\n") && errors.lines().count() == 1;
    assert!(code == 0 && (errors.is_empty() || is_cut), "{code} {errors}");
    assert!(read(folder.join("sins_out/log_replay.csv")).lines().count() > 5);
}

/// A session whose disk is full, or whose standard output is gone, keeps what was flown.
#[test]
#[cfg(target_os = "linux")]
fn a_session_keeps_what_was_flown() {
    let folder = folder("kept");
    let program = env!("CARGO_BIN_EXE_sins");
    let socket = UdpSocket::bind("127.0.0.1:0").unwrap();
    let port = UdpSocket::bind("127.0.0.1:0").unwrap().local_addr().unwrap().port();
    let live = format!("'{program}' live --from udp:{port} --format generic --silence-s 1 --record log.csv");
    for (name, script, code, words, rows) in [
        // A limit on the size of files acts like a full disk: 64 KiB or 128 KiB.
        (
            "full",
            format!("trap '' XFSZ; ulimit -f 128; exec {live} --set output.every_s=0.1"),
            1,
            "live.csv: cannot be written: File too large",
            20..300,
        ),
        ("gone", format!("exec {live} >/dev/full"), 1, "standard output cannot be written", 61..62),
        ("closed", format!("exec {live} >&-"), 0, "packets come from", 61..62),
    ] {
        let out = folder.join(name);
        std::fs::create_dir(&out).unwrap();
        let mut shell = std::process::Command::new("sh");
        shell.args(["-c", &script]).current_dir(&out).stdout(Stdio::null()).stderr(Stdio::piped());
        let program = shell.spawn().unwrap();
        let deadline = Instant::now() + Duration::from_secs(20);
        while !out.join("sins_out/.sins-live.html.part").exists() {
            assert!(Instant::now() < deadline, "{name}");
            std::thread::sleep(Duration::from_millis(20));
        }
        std::thread::sleep(Duration::from_millis(200));
        let truth = at("patrol");
        for tick in 0..601 {
            let packet = generic(&truth(f64::from(tick) * 0.1));
            let _ = socket.send_to(&packet, ("127.0.0.1", port));
            std::thread::sleep(Duration::from_micros(500));
        }
        let output = program.wait_with_output().unwrap();
        let errors = String::from_utf8(output.stderr).unwrap();
        assert!(output.status.code() == Some(code) && errors.contains(words), "{name}: {errors}");
        let found = read(out.join("sins_out/live.csv"));
        let lines = found.lines().count() - 1;
        assert!(rows.contains(&lines) && found.ends_with('\n'), "{name}: {lines} rows");
        let summary = read(out.join("sins_out/live_summary.csv"));
        assert!(summary.contains(&format!("records,{lines},")), "{name}");
        assert!(summary.contains(if name == "full" { "interrupted,1," } else { "interrupted,0," }), "{name}");
        // The log has at least what the records show.
        done(&out, &["fly", "sins_out/log.toml", "-q", "--name", "replay"]);
        assert!(read(out.join("sins_out/replay.csv")).starts_with(&found), "{name}");
    }
}

/// Silence is the time without a packet that could be flown: packets that are refused, and come all the time, do not matter; a pause
/// is no silence.
#[test]
fn refused_packets_are_silence_and_a_pause_is_none() {
    let folder = folder("silence");
    let peer = Peer::start(&folder, &["--format", "generic"]);
    send_patrol(&peer, 20);
    let standing = generic(&at("patrol")(19.0 * 0.1));
    let began = Instant::now();
    while began.elapsed() < Duration::from_millis(1500) {
        peer.send(&standing);
        std::thread::sleep(Duration::from_millis(20));
    }
    let mut peer = peer;
    assert!(peer.program.try_wait().unwrap().is_none(), "a pause ends no session");
    let began = Instant::now();
    while peer.program.try_wait().unwrap().is_none() {
        assert!(began.elapsed() < Duration::from_secs(10), "refused packets kept the session alive");
        let _ = peer.socket.send_to(b"nonsense", ("127.0.0.1", peer.port));
        std::thread::sleep(Duration::from_millis(20));
    }
    assert!(began.elapsed() > Duration::from_millis(900));
    let (_, said) = peer.finish();
    assert!(said.contains("no packet that can be flown for 1 s") && said.contains("20 flown"), "{said}");
}

/// Without a packet, the program says where it listens.
#[test]
fn silence_is_said() {
    let folder = folder("nothing");
    let peer = Peer::start(&folder, &["--format", "json"]);
    std::thread::sleep(Duration::from_millis(5500));
    let truth = at("patrol");
    (0..2).for_each(|tick| peer.send(&json(&truth(f64::from(tick)), "")));
    let port = peer.port;
    let (code, _, errors) = peer.end();
    let expected =
        format!("no packet for 5 s; listening at udp:127.0.0.1:{port} for json, from this machine alone");
    assert!(code == 0 && errors.contains(&expected), "{errors}");
}

/// What ends a run, and what cannot be begun.
#[test]
fn ends_and_options() {
    let folder = folder("ends");
    for (arguments, words) in [
        (&["live", "--from", "udp:0"][..], "state their rate, for example --rate-hz 60"),
        (&["live", "--from", "5500", "--rate-hz", "60"], "--from 5500: expected udp:PORT"),
        (&["live", "--from", "udp:0", "--rate-hz", "0"], "--rate-hz 0: must be above 0"),
        (&["live", "--from", "udp:0", "--rate-hz", "1e-9"], "options.sample_period_s"),
        (
            &["live", "--from", "udp:0", "--rate-hz", "60", "--to", "udp:1"],
            "--to udp:1: expected udp:HOST:PORT",
        ),
        (&["live", "log.csv", "--from", "udp:0"], "log.csv: is a flight log: expected a scene"),
        (&["live", "nowhere", "--from", "udp:0"], "nowhere: no such scene"),
        (
            &["live", "--from", "udp:0", "--rate-hz", "9", "--to", "udp:localhost:1", "--send", "bus"],
            "the scene has no unit",
        ),
        (&["live", "--from", "udp:0", "--rate-hz", "9", "--record", "../a.csv"], "--record = \"../a.csv\""),
    ] {
        let errors = rejected(&folder, arguments);
        assert!(errors.contains(words), "{arguments:?}: {errors}");
    }
    // Moved, with the option to end.
    let truth = at("patrol");
    let peer = Peer::start(&folder, &["--format", "generic", "--jump", "end", "--name", "moved"]);
    for tick in 0..10 {
        let mut sample = truth(f64::from(tick) * 0.1);
        sample.place.longitude_rad += if tick < 5 { 0.0 } else { 0.1 };
        peer.send(&generic(&sample));
    }
    let (_, said) = peer.finish();
    assert!(said.contains("the aircraft was moved") && said.contains("5 flown"), "{said}");
    // Only packets of another format: nothing was flown, and no file is left.
    let peer = Peer::start(&folder, &["--format", "generic", "--name", "none", "--seconds", "1"]);
    (0..3).for_each(|tick| peer.send(&fgfs(&truth(f64::from(tick)))));
    (0..2).for_each(|tick| peer.send(&generic(&truth(f64::from(tick)))));
    peer.finish();
    let left = std::fs::read_dir(folder.join("sins_out")).unwrap();
    assert!(
        left.map(|entry| entry.unwrap().file_name()).all(|name| !name.to_string_lossy().ends_with(".part"))
    );
}

/// Ctrl-C ends a run with complete files.
#[cfg(unix)]
#[test]
fn an_interrupt_ends_a_run() {
    let truth = at("patrol");
    let folder = folder("interrupt");
    let peer = Peer::start(&folder, &["--format", "generic"]);
    for tick in 0..50 {
        peer.send(&generic(&truth(f64::from(tick) * 0.1)));
    }
    (0..49).for_each(|_| drop(peer.answer()));
    let sent = std::process::Command::new("kill").args(["-INT", &peer.program.id().to_string()]).status();
    assert!(sent.unwrap().success());
    let (folder, said) = peer.finish();
    assert!(said.contains("50 flown"), "{said}");
    assert_eq!(read(folder.join("sins_out/live.csv")).lines().count(), 1 + 6);
    // Before the first packet there is nothing to keep.
    let peer = Peer::start(&folder, &["--format", "generic", "--name", "none"]);
    let sent = std::process::Command::new("kill").args(["-INT", &peer.program.id().to_string()]).status();
    assert!(sent.unwrap().success());
    let (code, _, errors) = peer.end();
    assert!(code == 130 && errors.contains("no interval was flown"), "{code} {errors}");
    assert!(!folder.join("sins_out/none.csv").exists());
}
