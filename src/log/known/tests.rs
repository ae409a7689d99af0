//! A sample of each known format, recognized and read.

use super::super::survey::survey;
use super::super::survey::tests::read;
use super::*;
use crate::scene::Scene;

/// A sample of each known format: two seconds, at 48° north and 11° east, at 300 m, climbing, banked to the right.
const SAMPLES: [(&str, &str); 27] = [
    (
        "Garmin G1000",
        "#airframe_info, log_version=\"1.00\"\n#yyy-mm-dd, hh:mm:ss, hh:mm, degrees, degrees, ft msl, ft wgs, deg, deg, kt, fpm, deg, deg, deg\n\
         Lcl Date, Lcl Time, UTCOfst, Latitude, Longitude, AltMSL, AltGPS, Pitch, Roll, GndSpd, VSpd, HDG, TRK, MagVar\n\
         2024-05-01, 12:00:00, +02:00, 48.0, 11.0, 800, 984.252, 2, 5, 100, 300, 356, 356, 4\n\
         2024-05-01, 12:00:01, +02:00, 48.00046, 11.0, 805, 989.252, 2, 5, 100, 300, 356, 356, 4\n",
    ),
    (
        "Garmin G5",
        "UTC Date (yyyy-mm-dd),UTC Time (hh:mm:ss),Latitude (WGS84 deg),Longitude (WGS84 deg),GPS Altitude (WGS84 ft),GPS Velocity E (m/s),GPS Velocity N (m/s),GPS Velocity U (m/s),Pitch (deg),Roll (deg),Magnetic Heading (deg),Magnetic Variation (deg)\n\
         UTC Date,UTC Time,Latitude,Longitude,Altitude,VelE,VelN,VelU,Pitch,Roll,Heading,MagVar\n\
         2024-05-01,12:00:00,48.0,11.0,984.252,0,50,1,2,5,356,4\n2024-05-01,12:00:01,48.00045,11.0,987.5,0,50,1,2,5,356,4\n",
    ),
    (
        "Garmin G3X",
        "Date (yyyy-mm-dd),UTC Time (hh:mm:ss),Latitude (deg),Longitude (deg),GPS Altitude (ft),GPS Velocity E (m/sec),GPS Velocity N (m/sec),GPS Velocity U (m/sec),Pitch (deg),Roll (deg),Magnetic Heading (deg)\n\
         2024-05-01,12:00:00,48.0,11.0,984.252,0,50,1,2,5,356\n2024-05-01,12:00:01,48.00045,11.0,987.5,0,50,1,2,5,356\n",
    ),
    (
        "X-Plane Data.txt",
        "   _real,_time |    __lat,__deg |    __lon,__deg |    __alt,ftmsl |    pitch,__deg |    _roll,__deg |    hding,_true |\n\
         0.0 | 48.0 | 11.0 | 984.252 | 2 | 5 | 0 |\n0.1 | 48.000045 | 11.0 | 984.6 | 2 | 5 | 0 |\n",
    ),
    (
        "FlightGear",
        "Time,/position/latitude-deg,/position/longitude-deg,/position/altitude-ft,/velocities/speed-north-fps,/velocities/speed-east-fps,/velocities/speed-down-fps,/orientation/roll-deg,/orientation/pitch-deg,/orientation/heading-deg\n\
         0,48.0,11.0,984.252,164.042,0,-3.28,5,2,0\n50,48.0000225,11.0,984.4,164.042,0,-3.28,5,2,0\n",
    ),
    (
        "SimConnect",
        "Time,PLANE LATITUDE,PLANE LONGITUDE,PLANE ALTITUDE,VELOCITY WORLD X,VELOCITY WORLD Y,VELOCITY WORLD Z,PLANE PITCH DEGREES,PLANE BANK DEGREES,PLANE HEADING DEGREES TRUE\n\
         0,48.0,11.0,984.252,0,3.28,164.042,-0.0349,-0.08727,0\n0.05,48.0000225,11.0,984.4,0,3.28,164.042,-0.0349,-0.08727,0\n",
    ),
    (
        "Sky Dolly",
        "Timestamp,UTC,Latitude,Longitude,Altitude,Pitch,Bank,Heading,Speed\n\
         0,12:00,48.0,11.0,984,-2,-5,0,164\n1000,12:00,48.00045,11.0,987,-2,-5,0,164\n",
    ),
    ("ArduPilot (POS)", "TimeUS,Lat,Lng,Alt,RelHomeAlt\n0,48.0,11.0,300,0\n100000,48.000045,11.0,300.1,0\n"),
    (
        "PX4 (vehicle_global_position)",
        "timestamp,timestamp_sample,lat,lon,alt,alt_ellipsoid,delta_alt,eph,epv\n\
         0,0,48.0,11.0,260,300,0,1,1\n200000,200000,48.00009,11.0,260,300.2,0,1,1\n",
    ),
    (
        "AirData",
        "time(millisecond),datetime(utc),latitude,longitude,altitude_above_seaLevel(feet), xSpeed(mph), ySpeed(mph), zSpeed(mph), compass_heading(degrees), pitch(degrees), roll(degrees)\n\
         0,2024-05-01 12:00:00,48.0,11.0,984.252,111.8,0,-2,0,2,5\n100,2024-05-01 12:00:00,48.000045,11.0,984.6,111.8,0,-2,0,2,5\n",
    ),
    (
        "OpenSky states",
        "time,icao24,lat,lon,velocity,heading,vertrate,callsign,baroaltitude,geoaltitude,lastposupdate\n\
         1700000000,3c6444,48.0,11.0,50,0,1,X,290,300,1700000000\n1700000001,3c6444,48.00045,11.0,50,0,1,X,291,301,1700000001\n",
    ),
    (
        "traffic",
        "timestamp,icao24,latitude,longitude,altitude,groundspeed,track,vertical_rate,callsign\n\
         2024-05-01 12:00:00+00:00,3c6444,48.0,11.0,984.252,97.2,0,200,X\n2024-05-01 12:00:01+00:00,3c6444,48.00045,11.0,987.5,97.2,0,200,X\n",
    ),
    (
        "Flightradar24",
        "Timestamp,UTC,Callsign,Position,Altitude,Speed,Direction\n\
         1714564800,2024-05-01T12:00:00Z,X1,\"48.0,11.0\",984.252,97,0\n\
         1714564830,2024-05-01T12:00:30Z,X1,\"48.0135,11.0\",1000,97,0\n",
    ),
    (
        "Columbus GNSS logger",
        "INDEX,TAG,DATE,TIME,LATITUDE N/S,LONGITUDE E/W,HEIGHT,SPEED,HEADING,FIX MODE,VALID,PDOP,HDOP,VDOP,VOX\n\
         1,T,240501,120000,48.000000N,011.000000E,300,180,0,3D,SPS,1.5,0.9,1.2,\n\
         2,T,240501,120001,48.000450N,011.000000E,301,180,0,3D,SPS,1.5,0.9,1.2,\n",
    ),
    (
        "NCAR research aircraft",
        "Time,LATC,LONC,GGALT,GGVEW,GGVNS,GGVSPD,PITCH,ROLL,THDG\n\
         43200,48.0,11.0,300,0,50,1,2,5,0\n43201,48.00045,11.0,301,0,50,1,2,5,0\n",
    ),
    (
        "JSBSim",
        "Time,Latitude (deg),Latitude Geodetic (deg),Longitude (deg),Altitude ASL (ft),V_{North} (ft/s),V_{East} (ft/s),V_{Down} (ft/s),Phi (deg),Theta (deg),Psi (deg)\n\
         0,47.8,48.0,11.0,984.252,164.042,0,-3.28,5,2,0\n0.01,47.8,48.0000045,11.0,984.3,164.042,0,-3.28,5,2,0\n",
    ),
    (
        "DJI flight record (OSD)",
        "CUSTOM.date [local],OSD.flyTime [s],OSD.latitude,OSD.longitude,OSD.height [ft],OSD.altitude [ft],OSD.xSpeed [MPH],OSD.ySpeed [MPH],OSD.zSpeed [MPH],OSD.pitch,OSD.roll,OSD.yaw,OSD.yaw [360]\n\
         5/1/2024,0,48.0,11.0,0,984.252,111.8,0,-2,2,5,0,0\n5/1/2024,0.1,48.000045,11.0,0.3,984.6,111.8,0,-2,2,5,0,0\n",
    ),
    (
        "X-Plane datarefs",
        "sim/time/total_flight_time_sec,sim/flightmodel/position/latitude,sim/flightmodel/position/longitude,sim/flightmodel/position/elevation,sim/flightmodel/position/local_vx,sim/flightmodel/position/phi,sim/flightmodel/position/theta,sim/flightmodel/position/psi\n\
         7,48.0,11.0,300,0,5,2,0\n7.1,48.000045,11.0,300.1,0,5,2,0\n",
    ),
    (
        "ROS topic (NavSatFix)",
        "%time,field.header.seq,field.header.stamp,field.latitude,field.longitude,field.altitude\n\
         1714564800100000000,1,1714564800000000000,48.0,11.0,300\n1714564801100000000,2,1714564801000000000,48.00045,11.0,301\n",
    ),
    (
        "EdgeTX telemetry",
        "Date,Time,1RSS(dB),GPS,GSpd(kmh),Hdg(°),Alt(m),Sats,Ptch(rad),Roll(rad),Yaw(rad)\n\
         2024-05-01,12:00:00.000,-60,48.000000 11.000000,180,0,300,14,0.0349,0.08727,0\n\
         2024-05-01,12:00:00.200,-60,48.000090 11.000000,180,0,300,14,0.0349,0.08727,0\n",
    ),
    (
        "u-blox NAV-PVT",
        "iTOW,fixType,numSV,lon,lat,height,hMSL,velN,velE,velD,gSpeed,headMot\n\
         216000000,3,14,110000000,480000000,300000,254000,50000,0,-1000,50000,0\n\
         216000200,3,14,110000000,480000900,300200,254200,50000,0,-1000,50000,0\n",
    ),
    (
        "MAVLink GLOBAL_POSITION_INT",
        "timestamp,time_boot_ms,lat,lon,alt,relative_alt,vx,vy,vz,hdg,roll,pitch,yaw\n\
         1714564800.0,1000,480000000,110000000,300000,0,5000,0,-100,0,0.08727,0.0349,0\n\
         1714564800.2,1200,480000900,110000000,300200,200,5000,0,-100,0,0.08727,0.0349,0\n",
    ),
    (
        "ForeFlight track",
        "Pilot,Tail Number,Start Latitude,Start Longitude,Start Time\nA,X,48,11,1714564800000\n\
         Timestamp,Latitude,Longitude,Altitude,Course,Speed,Bank,Pitch,Horizontal Error,Vertical Error,g Load\n\
         1714564800000,48.0,11.0,984.252,0,97.2,5,2,5,3,1\n1714564801000,48.00045,11.0,987.5,0,97.2,5,2,5,3,1\n",
    ),
    (
        "readsb trace",
        "timestamp,lat,lon,alt_baro,gs,track,flags,baro_rate,alt_geom,geom_rate,ias,roll,true_heading\n\
         1714564800.3,48.0,11.0,ground,97.2,0,0,0,984.252,0,90,5,0\n1714564801.3,48.00045,11.0,800,97.2,0,0,192,987.5,192,90,5,0\n",
    ),
    (
        "SBET as text",
        "time, latitude, longitude, altitude, x_vel, y_vel, z_vel, roll, pitch, platform_heading, wander_angle\n\
         216000.0, 0.8377580409572782, 0.19198621771937624, 300, 0, 50, 1, 0.08727, 0.0349, -0.25, 0.25\n\
         216000.1, 0.8377588263554416, 0.19198621771937624, 300, 0, 50, 1, 0.08727, 0.0349, -0.25, 0.25\n",
    ),
    (
        "Litchi",
        "latitude,longitude,altitude(feet),speed(mph),time(millisecond),datetime(utc),velocityX(mps),velocityY(mps),velocityZ(mps),pitch(deg),roll(deg),yaw(deg),altitude(m),speed(mps)\n\
         48.0,11.0,984.252,111.8,0,2024-05-01 12:00:00,50,0,-1,2,5,0,300,50\n48.000045,11.0,984.6,111.8,100,2024-05-01 12:00:00,50,0,-1,2,5,0,300.1,50\n",
    ),
    (
        "Betaflight or INAV blackbox",
        "loopIteration, time (us), attitude[0], attitude[1], attitude[2], GPS_fixType, GPS_numSat, GPS_coord[0], GPS_coord[1], GPS_altitude, GPS_speed (m/s), GPS_velned[0], GPS_velned[1], GPS_velned[2]\n\
         0, 100000000, 50, 20, 0, 3, 12, 48.0000000, 11.0000000, 300, 50.00, 5000, 0, -100\n100, 100100000, 50, 20, 0, 3, 12, 48.0000450, 11.0000000, 300.1, 50.00, 5000, 0, -100\n",
    ),
];

#[test]
fn every_known_format_is_recognized_and_read() {
    let names = KNOWN.iter().chain(&RECORDERS).map(|known| known.name);
    assert!(names.eq(SAMPLES.iter().map(|(name, _)| *name)));
    for (name, table) in SAMPLES {
        let (survey, log) = read(table);
        assert_eq!(survey.format, Some(name), "{survey:?}");
        assert!(survey.questions.is_empty(), "{survey:?}");
        let sample = log.samples()[0];
        assert_eq!(log.samples().len(), 2, "{name}");
        assert!((sample.place.latitude_rad.to_degrees() - 48.0).abs() < 1e-9, "{name}: {sample:?}");
        assert!((sample.place.longitude_rad.to_degrees() - 11.0).abs() < 1e-9, "{name}: {sample:?}");
        assert!((sample.place.height_m - 300.0).abs() < 0.1, "{name}: {sample:?}");
        if !survey.text.contains("coordinated") {
            let angles = [sample.euler.roll, sample.euler.pitch, sample.euler.heading].map(f64::to_degrees);
            assert!((angles[0] - 5.0).abs() < 1e-2 && (angles[1] - 2.0).abs() < 1e-2, "{name}: {angles:?}");
            let heading = if name == "Garmin G3X" { 356.0 } else { 0.0 };
            assert!(
                (angles[2] - heading).rem_euclid(360.0).min((heading - angles[2]).rem_euclid(360.0)) < 1e-6,
                "{name}: {angles:?}"
            );
        }
        if let Some(v_n) = sample.v_n {
            let [east, north, up]: [f64; 3] = v_n.into();
            assert!(
                east.abs() < 1e-9 && (north - 50.0).abs() < 2.0 && up > 0.8 && up < 2.0,
                "{name}: {v_n:?}"
            );
        }
    }
}

/// The speed of a receiver beside its velocities has their unit, which a speed alone has not: it agrees with what flies.
#[test]
fn the_speed_beside_velocities_has_their_unit() {
    let circle = |k: i32| {
        let angle = 0.02 * f64::from(k);
        let [north_m, east_m] = [500.0 * angle.sin(), 500.0 * (1.0 - angle.cos())];
        let [north, east] = [50.0 * angle.cos(), 50.0 * angle.sin()];
        let latitude = 48e7 + north_m / 111_195.0 * 1e7;
        let longitude = 11e7 + east_m / (111_195.0 * 48_f64.to_radians().cos()) * 1e7;
        format!(
            "{},3,14,{longitude:.0},{latitude:.0},300000,254000,{:.0},{:.0},0,50000,0\n",
            216_000_000 + 200 * k,
            1e3 * north,
            1e3 * east
        )
    };
    let rows: String = (0..200).map(circle).collect();
    let names = "iTOW,fixType,numSV,lon,lat,height,hMSL,velN,velE,velD,gSpeed,headMot\n";
    let flown = |table: &str| {
        let found = survey(table.as_bytes()).unwrap();
        assert_eq!(found.format, Some("u-blox NAV-PVT"));
        let text = format!("[flight]\nfile = \"a.csv\"\n[log]\n{}", found.text);
        Scene::parse(text.as_bytes()).unwrap().read_log(table.as_bytes()).unwrap()
    };
    let log = flown(&format!("{names}{rows}"));
    let said: Vec<&str> = log.notes().iter().map(|note| &*note.sentence).collect();
    assert!(said.iter().any(|note| note.contains("gSpeed (speed in mm/s)")), "{said:?}");
    assert!(log.of_rows().is_empty(), "{:?}", log.of_rows());
    // Half of the speed still contradicts it.
    let half = format!("{names}{rows}").replace(",50000,0\n", ",25000,0\n");
    assert!(!flown(&half).of_rows().is_empty());
}

/// A simulator that gives its angles in radians may give its position in radians too.
#[test]
fn a_small_position_beside_radians_is_asked_about() {
    let (_, table) = SAMPLES.iter().find(|(name, _)| *name == "SimConnect").unwrap();
    let rows = |scale: f64| {
        let mut lines = table.lines();
        let names = lines.next().unwrap();
        let at = |name: &str| names.split(',').position(|own| own == name).unwrap();
        let places = [at("PLANE LATITUDE"), at("PLANE LONGITUDE")];
        let scaled = lines.map(|line| {
            let cells = line.split(',').enumerate().map(|(place, cell)| match places.contains(&place) {
                true => (cell.parse::<f64>().unwrap() * scale).to_string(),
                false => cell.to_owned(),
            });
            cells.collect::<Vec<_>>().join(",")
        });
        format!("{names}\n{}\n", scaled.collect::<Vec<_>>().join("\n"))
    };
    assert!(survey(rows(1.0).as_bytes()).unwrap().questions.is_empty());
    let found = survey(rows(1_f64.to_radians()).as_bytes()).unwrap();
    assert_eq!(found.format, Some("SimConnect"));
    assert!(found.questions[0].sentence.ends_with("are small: degrees or radians?"), "{found:?}");
    assert!(!found.text.contains("latitude"), "{found:?}");
}
