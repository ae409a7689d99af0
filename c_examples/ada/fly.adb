--  Flies a built-in scene and prints the navigation of its INS: fly patrol

with Ada.Command_Line;     use Ada.Command_Line;
with Ada.Text_IO;          use Ada.Text_IO;
with Interfaces;           use Interfaces;
with Interfaces.C;         use Interfaces.C;
with Interfaces.C.Strings; use Interfaces.C.Strings;
with Sins;                 use Sins;

procedure Fly is

   package Numbers is new Ada.Text_IO.Float_IO (double);

   Failed : exception;

   --  Raises Failed if a call failed: errors are negative. The library keeps the sentence of a simulator's function with the
   --  simulator. The sentences of other functions belong to the thread: Of_Sim is null.
   procedure Check (Call : String; Of_Sim : sins_sim; Status : sins_status) is
      Capacity : constant := 1024;
      Sentence : char_array (0 .. Capacity - 1) := (others => nul);
      Needed   : size_t := 0;
   begin
      if Status < 0 then
         if sins_last_error (Of_Sim, Sentence, Capacity, Needed) < 0 then
            Sentence (0) := nul;
         end if;
         Put_Line (Standard_Error, "fly: " & Call & ": " & To_Ada (Sentence) & " (" & Value (sins_status_string (Status)) & ")");
         raise Failed;
      end if;
   end Check;

   --  Prints the components of a vector with all their digits.
   procedure Put_Vector (Name : String; Vector : sins_double_3) is
   begin
      Put (Name);
      for Number of Vector loop
         Put (" ");
         Numbers.Put (Number, Fore => 2, Aft => 16, Exp => 4);
      end loop;
      New_Line;
   end Put_Vector;

   procedure Put_Fixed (Number : double; Fore, Aft : Field) is
   begin
      Numbers.Put (Number, Fore, Aft, Exp => 0);
   end Put_Fixed;

   procedure Put_Row (Row : sins_record) is
   begin
      Put_Fixed (Row.time_s, 8, 2);
      Put_Fixed (Row.navigation.latitude_rad / SINS_DEG, 5, 6);
      Put_Fixed (Row.navigation.longitude_rad / SINS_DEG, 5, 6);
      for Axis of Row.navigation_errors.position_enu_m loop
         Put_Fixed (Axis, 8, 3);
      end loop;
      New_Line;
   end Put_Row;

   procedure Fly_Scene (Name : String) is
      Scene   : sins_scene;
      Play    : sins_play;
      Samples : sins_scene_samples;
      Row     : sins_record_array (1 .. 1);
      Written : size_t := 0;
      Status  : sins_status := SINS_OK;
   begin
      Check ("sins_scene_create_builtin", null, sins_scene_create_builtin (To_C (Name), Scene));
      Check ("sins_scene_get_samples", null, sins_scene_get_samples (Scene, null, Samples));
      Check ("sins_scene_set_values", null,
             sins_scene_set_values
               (Scene, To_C ("output.every_s =" & double'Image (double'Max (Samples.duration_s / 20.0, Samples.period_s)))));
      Check ("sins_play_create", null, sins_play_create (Scene, null, Play));

      Put_Line ("     time s     lat deg    long deg      east m     north m        up m");
      --  From record to record: with the temperature, the failures, the updates and the unit of the scene.
      while Status = SINS_OK loop
         Status := sins_play_run (Play, Row, 1, Written);
         Check ("sins_play_run", null, Status);
         if Written = 1 then
            Put_Row (Row (1));
         end if;
      end loop;

      New_Line;
      Put_Line ("errors at the end, navigation - truth, east-north-up");
      Put_Vector ("      position m", Row (1).navigation_errors.position_enu_m);
      Put_Vector ("    velocity m/s", Row (1).navigation_errors.velocity_enu_m_s);
      Put_Vector ("misalignment rad", Row (1).navigation_errors.misalignment_enu_rad);

      Check ("sins_play_destroy", null, sins_play_destroy (Play));
      Check ("sins_scene_destroy", null, sins_scene_destroy (Scene));
   end Fly_Scene;

begin
   if Argument_Count /= 1 then
      Put_Line (Standard_Error, "usage: fly NAME of a built-in scene");
      Set_Exit_Status (2);
   elsif sins_abi_version /= SINS_HEADER_ABI then
      Put_Line (Standard_Error, "fly: the library has interface version" & sins_abi_version'Image & ", this program needs"
                & Integer'Image (SINS_HEADER_ABI));
      Set_Exit_Status (Failure);
   else
      Fly_Scene (Argument (1));
   end if;
exception
   when Failed =>
      Set_Exit_Status (Failure);
end Fly;
