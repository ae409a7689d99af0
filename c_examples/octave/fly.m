% Flies five minutes of a fighter's log with the sensors of a scene, using the MEX file sins_fly, and prints the errors at the end.
% Also for MATLAB. Build the MEX file first, see docs/hosts.md.

examples = fileparts(fileparts(mfilename('fullpath')));
samples = dlmread(fullfile(examples, 'flights', 'fighter_aerobatics.csv'), ',', 3, 0); % after two comments and the names
scene = fileread(fullfile(examples, 'scenes', 'fighter.toml'));

table = sins_fly(samples, scene);
fprintf('errors at the end, navigation - truth, east-north-up\n');
fprintf('position m       %.17g %.17g %.17g\n', table(end, 11:13));
fprintf('velocity m/s     %.17g %.17g %.17g\n', table(end, 14:16));
fprintf('misalignment rad %.17g %.17g %.17g\n', table(end, 17:19));

% A sample that is not later than the previous one gives an error with the name of the status and the row.
try
    sins_fly(samples([1 2 2], :), scene);
catch failure
    fprintf('%s\n%s\n', failure.identifier, failure.message);
end
