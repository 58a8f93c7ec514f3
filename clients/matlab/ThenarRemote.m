classdef ThenarRemote < handle
  % Remote control of thenar from MATLAB (R2020b or later) and GNU Octave (with its package instrument-control).
  %
  %   thenar = ThenarRemote('127.0.0.1', 8081);              % thenar view jaw_box --remote 8081
  %   names = thenar.call('catalogue.list', struct('what', 'worlds'));
  %   thenar.call('hand.close', struct());
  %   delete(thenar);
  %
  % Methods and their parameters are those of docs/remote.md: SI units, radians, positions [x y z], rotations [w x y z].
  % A parameter that is a list of one text or object is a cell: {'joints'}.

  properties
    timeout = 60   % for a reply [s]
    hello          % what the server says of itself
  end

  properties (SetAccess = private)
    connection
    octave         % whether this is Octave
    last_id = 0
    bytes          % that came behind the last reply, uint8 row
  end

  methods
    function self = ThenarRemote(host, port, token)
      % Connects; token is what the server printed. Left out, it is what a server of this user on this machine keeps.
      self.octave = exist('OCTAVE_VERSION', 'builtin') ~= 0;
      self.bytes = zeros(1, 0, 'uint8');
      if self.octave
        pkg('load', 'instrument-control');
      end
      self.connection = tcpclient(host, port);
      params = struct();
      if nargin < 3
        token = '';
        if strcmp(host, 'localhost') || strcmp(host, '::1') || strncmp(host, '127.', 4)
          token = ThenarRemote.stored_token(port);
        end
      end
      if ~isempty(token)
        params.token = token;
      end
      self.hello = self.call('session.hello', params);
    end

    function result = call(self, method, params)
      % The result of a method. Its errors are thrown as 'thenar:refused', with the code in front: "-32602 params..".
      if nargin < 3
        params = struct();
      end
      self.last_id = self.last_id + 1;
      request = struct('jsonrpc', '2.0', 'id', self.last_id, 'method', method, 'params', params);
      text = [jsonencode(request), char(10)];
      write(self.connection, unicode2native(text, 'UTF-8'));
      reply = jsondecode(self.read_line());
      while ~isequal(reply.id, self.last_id) && ~(isempty(reply.id) && isfield(reply, 'error'))
        reply = jsondecode(self.read_line());   % of a request that was given up on
      end
      if isfield(reply, 'error')
        error('thenar:refused', '%d %s', reply.error.code, reply.error.message);
      end
      result = reply.result;
    end

    function stop(self)
      % Asks the request that runs to stop, as one that another client waits for.
      write(self.connection, uint8(['{"jsonrpc":"2.0","method":"session.stop"}', char(10)]));
    end

    function delete(self)
      self.connection = [];
    end
  end

  methods (Static)
    function token = stored_token(port)
      % The token that a server of this user at a port of this machine keeps in a file; empty if there is none.
      token = '';
      newest = -Inf;
      places = {'XDG_RUNTIME_DIR', 'thenar'; 'XDG_CACHE_HOME', 'thenar'; 'HOME', fullfile('.cache', 'thenar')};
      for i = 1:size(places, 1)
        file = fullfile(getenv(places{i, 1}), places{i, 2}, sprintf('%d.token', port));
        about = dir(file);
        if ~isempty(getenv(places{i, 1})) && numel(about) == 1 && about.datenum > newest
          token = strtrim(fileread(file));
          newest = about.datenum;
        end
      end
    end
  end

  methods (Access = private)
    function text = read_line(self)
      % The next line, without its end.
      waited = tic();
      last = find(self.bytes == 10, 1);
      while isempty(last)
        if toc(waited) > self.timeout
          error('thenar:timeout', 'no reply within %g s', self.timeout);
        end
        come = self.read_some();
        if isempty(come)
          pause(0.0005);
          continue
        end
        found = find(come == 10, 1);
        if ~isempty(found)
          last = numel(self.bytes) + found;
        end
        self.bytes = [self.bytes, come];
      end
      text = native2unicode(self.bytes(1:last - 1), 'UTF-8');
      self.bytes = self.bytes(last + 1:end);
    end

    function come = read_some(self)
      % Bytes that have come, as a row; none if there are none.
      if self.octave
        count = self.connection.NumBytesAvailable;
      else
        count = self.connection.NumBytesAvailable;
      end
      come = zeros(1, 0, 'uint8');
      if count > 0
        come = reshape(uint8(read(self.connection, count)), 1, []);
      end
    end
  end
end
