//! A sample of each known format, recognized and read.

use super::super::survey::tests::read;
use super::*;

/// A sample of each known format: two seconds, at 48° north and 11° east, at 300 m, climbing, banked to the right.
const SAMPLES: [(&str, &str); 16] = [
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
];

#[test]
fn every_known_format_is_recognized_and_read() {
    assert_eq!(KNOWN.map(|known| known.name), SAMPLES.map(|(name, _)| name));
    for (name, table) in SAMPLES {
        let (survey, log) = read(table);
        assert_eq!(survey.format, Some(name), "{survey:?}");
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
