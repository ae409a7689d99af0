--  The same calls as in calls.c.

with Ada.Text_IO;          use Ada.Text_IO;
with Interfaces;           use Interfaces;
with Interfaces.C;         use Interfaces.C;
with Interfaces.C.Strings; use Interfaces.C.Strings;
with Sins;                 use Sins;

procedure Calls is

   package Numbers is new Float_IO (double);

   procedure Show (Label : String; Number : double) is
   begin
      Put (Label & " ");
      Numbers.Put (Number, Fore => 1, Aft => 16, Exp => 4);
      New_Line;
   end Show;

   procedure Check (Status : sins_status) is
   begin
      if Status < 0 then
         raise Program_Error with Value (sins_status_string (Status));
      end if;
   end Check;

   type Bytes is array (1 .. SINS_SNAPSHOT_MAX_SIZE) of Unsigned_8;

   Capacity    : constant := 64;
   Sim, Second : sins_sim;
   Flight      : sins_flight;
   Samples     : sins_flight_sample_array (0 .. 120);
   Frozen      : Bytes;
   Options     : sins_options;
   Gyro        : sins_gyro_params;
   Start       : sins_flight_start;
   Manoeuvres  : sins_manoeuvre_array (0 .. 1);
   Records     : sins_record_array (0 .. 4);
   Navigation  : sins_navigation;
   Info        : sins_error_info;
   Name        : char_array (0 .. Capacity - 1) := (others => nul);
   Written     : size_t := 0;
   Needed      : size_t := 0;

begin
   Check (sins_scene_builtin_name (1, Name, Capacity, Needed));
   Show (To_Ada (Name), double (Needed));

   Start.latitude_rad := 0.7;
   Start.speed_m_s := 100.0;
   Manoeuvres (0).kind := SINS_MANOEUVRE_STRAIGHT;
   Manoeuvres (0).duration_s := 5.0;
   Manoeuvres (1).kind := SINS_MANOEUVRE_ROLL;
   Manoeuvres (1).duration_s := 10.0;
   Manoeuvres (1).turns := 1.0;
   Check (sins_flight_create (Start, Manoeuvres, Manoeuvres'Length, Flight));
   for K in Samples'Range loop
      Check (sins_flight_sample_at (Flight, double (K) / 8.0, Samples (K)));
   end loop;

   Options.scheme := SINS_SCHEME_POLYNOMIAL;
   Options.subsamples := 3;
   Check (sins_create (Options, Sim));
   Gyro.misalignment_rad (0, 1) := 1.0e-3;
   Gyro.misalignment_rad (2, 0) := 2.0e-3;
   Check (sins_set_gyro (Sim, Gyro));
   Check (sins_run (Sim, Samples, Samples'Length, 30, Records, 5, Written));
   Show ("written", double (Written));
   for K in 0 .. Written - 1 loop
      Show ("time", Records (K).time_s);
      Show ("velocity", Records (K).navigation_errors.velocity_enu_m_s (1));
      Show ("misalignment", Records (K).navigation_errors.misalignment_enu_rad (2));
   end loop;

   Check (sins_snapshot_save (Sim, Frozen'Address, Frozen'Length, Needed));
   Show ("snapshot", double (Needed));
   Check (sins_create (Options, Second));
   Check (sins_snapshot_load (Second, Frozen'Address, Needed));
   Check (sins_get_navigation (Second, Navigation));
   Show ("quaternion", Navigation.quaternion_nb (3));

   Gyro.misalignment_rad (2, 1) := 2.0;
   Show ("refused", double (sins_set_gyro (Sim, Gyro)));
   Check (sins_last_error_info (Sim, Info));
   Show (To_Ada (Info.field), double (Info.index));

   Check (sins_destroy (Sim));
   Check (sins_destroy (Second));
   Check (sins_flight_destroy (Flight));
end Calls;
