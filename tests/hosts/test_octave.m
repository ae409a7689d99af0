% Tests of sins_fly with good and with bad input.

function refused(identifier, words, varargin)
    try
        sins_fly(varargin{:});
        error('test:flown', '%s was to be refused', identifier);
    catch failure
        assert(strcmp(failure.identifier, identifier) && ~isempty(strfind(failure.message, words)), failure.message);
    end
end

rest = [(0:10).', repmat([0.7 0 0 0 0 0 0 0 0], 11, 1)];
drift = "[flight]\nbuiltin = \"rest\"\n[gyro]\nbias_deg_h = 1\n";
table = sins_fly(rest, drift);
assert(size(table), [11 19]);
assert(table(:, 1), rest(:, 1));
drifted = 10 * pi / 180 / 3600; % 10 s with 1 deg/h; meanwhile the Earth's rotation turns the axes
assert(all(abs(abs(table(end, 17:19)) - drifted) < 2 * 10 * 7.3e-5 * drifted));
assert(isequal(table, sins_fly(rest, drift)));
assert(max(max(abs(sins_fly(rest)(:, 17:19)))) < 100 * eps); % without a scene, sensors are ideal
assert(size(sins_fly(zeros(0, 10))), [0 19]);

refused('sins:usage', 'columns', rest(:, 1:9));
refused('sins:usage', 'columns', single(rest));
refused('sins:usage', 'columns', rest * i);
refused('sins:usage', 'columns', rest, 3);
refused('sins:usage', 'columns');
refused('sins:SINS_SCENE_HAS_FAULTS', 'line 2: ', rest, "[flight]\nbuiltin = \"petrol\"\n");
south = rest;
south(3, 2) = -2;
refused('sins:SINS_ERROR_INVALID_ARGUMENT', 'row 3: at 2 s: sample.latitude_rad', south);
late = rest;
late(5:end, 1) = late(5:end, 1) + 100;
for k = 1:5000 % more handles than can exist at once
    refused('sins:SINS_ERROR_DISCONTINUITY', 'row 5: ', late, drift);
end
disp('sins_fly: good and bad input')
