% Flies five minutes of a fighter's log with the sensors of a scene, by the MEX file sins_fly, and prints the errors at the end.
% For MATLAB as well. Build first, see docs/hosts.md.

examples = fileparts(fileparts(mfilename('fullpath')));
samples = dlmread(fullfile(examples, 'flights', 'fighter_aerobatics.csv'), ',', 3, 0); % behind two comments and the names
scene = fileread(fullfile(examples, 'scenes', 'fighter.toml'));

table = sins_fly(samples, scene);
errors = reshape(table(end, 11:19), 3, 3).'; % rows: position, velocity, misalignment; columns: east, north, up
for axis = 1:3
    fprintf('%.17g %.17g %.17g\n', errors(:, axis));
end

% A sample that stands still in time is refused, by name and with its row.
try
    sins_fly(samples([1 2 2], :), scene);
catch failure
    fprintf(2, '%s: %s\n', failure.identifier, failure.message);
end
